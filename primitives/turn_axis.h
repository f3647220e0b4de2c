// Axes about which a surface, or much of it, is the same at every turn.
#pragma once

#include <span>
#include <vector>

#include "primitives/surface_sample.h"

namespace prehend {

// A line in the frame O of the surface.
struct TurnAxis {
  Vector3 p_O = Vector3::Zero();
  Vector3 direction_O = Vector3::UnitZ();  // unit
};

// A point of the surface, seen from an axis.
struct SeenFromAxis {
  double z = 0.0;           // along the axis, from p_O
  double radius = 0.0;      // distance from the axis
  double angle = 0.0;       // about the axis [rad], from a direction across it
  double outward = 0.0;     // parts of the normal: away from the axis,
  double tangential = 0.0;  // and about it, which is 0 on a surface of revolution
};

std::vector<SeenFromAxis> seen_from(const TurnAxis& axis, std::span<const SurfacePoint> points);

// Axes about which many of these points may turn. The normals of a surface of revolution meet its
// axis: their lines lie in a linear complex (Pottmann, Peternell and Ravani 1999, "An introduction
// to line geometry with applications"). Robust fits of one start from the principal axes of all
// points and of their normals, and from what patches of the surface tell. Near-identical ones come
// once.
std::vector<TurnAxis> likely_axes(std::span<const SurfacePoint> points);

}  // namespace prehend
