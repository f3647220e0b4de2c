// Surfaces of revolution: a profile with rounded corners, turned about the z axis.
#pragma once

#include <vector>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// A corner of a profile in the half plane x = distance from the axis (>= 0), y = height, cut by an
// arc of radius `fillet` (0: sharp). An arc too large for its neighbours is made smaller.
struct ProfileCorner {
  Eigen::Vector2d at;
  double fillet = 0.0;
};

// The inner side of a vessel: corners parallel to `outer` (from the axis at the bottom to the lip)
// at distance `wall` to its left, listed from the lip back to the axis.
std::vector<ProfileCorner> inner_side(const std::vector<ProfileCorner>& outer, double wall);

// Points along the rounded profile, at most about `edge` apart; ends of straight pieces are kept.
// An arc of 90 degrees gets two cells or more, one when it is shorter than half an edge; a fillet
// that takes less than a twelfth of an edge from its sides is left sharp.
std::vector<Eigen::Vector2d> profile_points(const std::vector<ProfileCorner>& corners, double edge);

// Ring i holds the vertices first to first + count - 1, evenly spread about the axis.
struct Ring {
  int first = 0;
  int count = 1;
};

struct Revolved {
  TriangleMesh mesh;
  std::vector<Ring> rings;          // one for each profile point, a single vertex on the axis
  std::vector<int> first_triangle;  // of the band between ring i and i + 1
};

struct RevolveOptions {
  // Wanted length of an edge along a ring [m]; a ring has 2 pi r / edge vertices, and the widest at
  // least 16.
  double edge = 0.005;
  // Vertex j of n lies at angle 2 pi (j + 1/2) / n instead of 2 pi j / n.
  bool half_step = false;
};

// Turns a profile that starts and ends on the axis, outside on its right, into a closed mesh. In a
// band between rings of equal count n, the cell between vertices j and j + 1 is the triangles
// first_triangle + 2 j and the next one.
Revolved revolve(const std::vector<Eigen::Vector2d>& profile, const RevolveOptions& options);

}  // namespace prehend
