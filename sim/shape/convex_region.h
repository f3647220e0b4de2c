// Convex sets as intersections of half-spaces: regions of an object with a density of their own.
#pragma once

#include <optional>
#include <vector>

#include "sim/shape/primitive.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The set normal . p <= offset; the normal is unit.
struct HalfSpace {
  Vector3 normal = Vector3::UnitZ();
  double offset = 0.0;  // m
};

// The points that are in all of these.
using ConvexRegion = std::vector<HalfSpace>;

// A box; a cylinder, as a prism of 32 sides with the same volume; or a ball, as a polyhedron of 80
// faces with the same volume. Throws InputError for other shapes.
ConvexRegion region_of(const Primitive& primitive);

// A point of the region and the box whose distance from every plane of the region is at least 1e-12
// of the box's diagonal: the mean of the corners of what they have in common. nullopt where there
// is none, which is where they have (next to) nothing in common.
std::optional<Vector3> inner_point(const ConvexRegion& region, const Bounds& box);

}  // namespace prehend
