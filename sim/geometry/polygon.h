// Splits simple polygons into triangles.
#pragma once

#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// Twice the signed area of the polygon, positive when counter-clockwise.
double doubled_area(const std::vector<Eigen::Vector2d>& corners);

// Ear clipping (Meisters 1975), the best-shaped ear first: n - 2 triangles of indices into
// `corners`, counter-clockwise, every corner used. O(n^2). Straight corners are allowed.
// Empty when the polygon has no such split: fewer than three corners, not counter-clockwise, or
// crossing itself.
std::vector<Triangle> triangulate_polygon(const std::vector<Eigen::Vector2d>& corners);

// The same for a face in space, in the plane of its mean normal (Newell): indices into `corners`,
// wound like the face. A face that has no such split (bent or crossing itself) becomes a fan about
// its first corner; fewer than three corners give nothing.
std::vector<Triangle> triangulate_face(const std::vector<Vector3>& corners);

}  // namespace prehend
