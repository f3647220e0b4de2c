// Solids made of cross-sections: lofts and capsules, closed and outward-oriented.
#pragma once

#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A polygon [m], counter-clockwise and simple, in the plane z = at [m].
struct LoftSection {
  double at = 0.0;
  std::vector<Eigen::Vector2d> corners;
};

// The surface that joins corner k of each section to corner k of the next, closed by the first and
// the last section: 2 m (n - 1) + 2 (m - 2) triangles for n sections of m corners. Each cell
// between two sections is split along its shorter diagonal. Neighbouring sections should be alike:
// whether the sides cross each other is not checked. Throws InputError for fewer than two sections,
// heights that do not increase, sections with different numbers of corners, and a section that is
// not simple and counter-clockwise.
TriangleMesh make_loft(const std::vector<LoftSection>& sections);

// All points within `radius` [m] of the segment from `from` to `to` [m], approximated from inside:
// `sides` (4 to 360) meridians, each with corners on the sphere every quarter / max(1, sides / 4)
// of a circle. from = to gives a sphere. Throws InputError for a radius that is not positive and a
// number of sides out of range.
TriangleMesh make_capsule(const Vector3& from, const Vector3& to, double radius, int sides = 12);

}  // namespace prehend
