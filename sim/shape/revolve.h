// Surfaces of revolution: a profile curve with rounded corners, turned about the z axis.
#pragma once

#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// A corner of a profile polygon in the half plane x = distance from the axis (>= 0) [m], y = height
// [m]. The corner is rounded by an arc of radius `fillet` [m] (0: sharp), which is made smaller
// where the adjacent sides are too short for it.
struct ProfileCorner {
  Eigen::Vector2d at;
  double fillet = 0.0;
};

// The inner profile of a vessel with a wall of constant thickness: the profile `outer`, which leads
// from the axis at the bottom to the lip, offset by `wall` [m] to its left. It is listed in the
// opposite direction, from the lip to the axis, so that it continues `outer`.
std::vector<ProfileCorner> inner_side(const std::vector<ProfileCorner>& outer, double wall);

// Points along the rounded profile, about `edge` [m] apart; the ends of straight pieces are kept.
// An arc of 90 degrees is divided into at least two segments, or one when it is shorter than half
// of `edge`; a fillet that shortens its sides by less than a twelfth of `edge` is left sharp.
std::vector<Eigen::Vector2d> profile_points(const std::vector<ProfileCorner>& corners, double edge);

// The vertices of a revolved mesh that come from one profile point: `first` to first + count - 1,
// at equal angles about the axis.
struct Ring {
  int first = 0;
  int count = 1;
};

// A mesh of revolution and the place of its vertices and triangles in the mesh.
struct Revolved {
  TriangleMesh mesh;
  std::vector<Ring> rings;          // per profile point; a point on the axis is one vertex
  std::vector<int> first_triangle;  // per band between ring i and i + 1
};

// Turns a profile into a closed mesh. The profile starts and ends on the axis and has the outside
// on its right. In a band between two rings of equal count, the cell between vertices j and j + 1
// consists of triangles first_triangle + 2 j and first_triangle + 2 j + 1.
//
// `edge` is the wanted length of an edge along a ring [m]: a ring of radius r gets about
// 2 pi r / edge vertices, at least 6; the edge is shorter where the widest ring would get less than
// 16. Vertex j of n lies at angle 2 pi j / n, with `half_step` at 2 pi (j + 1/2) / n.
Revolved revolve(const std::vector<Eigen::Vector2d>& profile, double edge, bool half_step = false);

}  // namespace prehend
