// Axes of revolution of a surface.
#pragma once

#include <vector>

#include "sim/shape/cloud/object_view.h"

namespace prehend {

struct AxisFit {
  Vector3 direction = Vector3::UnitZ();  // unit
  Vector3 point = Vector3::Zero();
  double misfit = 0.0;  // how far normals pass the axis, in the mean, at most kMostMiss each [m]
};

inline constexpr double kMostMiss = 0.01;

// The line along `direction` that the normals of the surface meet best, as those of a surface of
// revolution do: least squares, reweighted (after Pottmann and Wallner 2001).
AxisFit fit_axis(const std::vector<SeenPoint>& points, const Vector3& direction);

// The best of directions in space, one for each of the best `count` that are not neighbours.
std::vector<AxisFit> find_axes(const std::vector<SeenPoint>& points, std::size_t count);

}  // namespace prehend
