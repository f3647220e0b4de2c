// Distances and intersections of triangle meshes by trying every pair of triangles. A reference for
// the proximity queries of the library: slow, and without any code in common with them (no trees,
// no FCL). Distances are in metres; both meshes are given in one common frame.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend::test {

using Corners = std::array<Vector3, 3>;

// A mesh's triangles as corners, transformed by `X` into the common frame.
inline std::vector<Corners> soup(const TriangleMesh& mesh, const Pose& X = Pose::Identity()) {
  std::vector<Corners> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](std::size_t k) -> Vector3 {
      return X * mesh.vertices[static_cast<std::size_t>(t[k])];
    };
    triangles.push_back({corner(0), corner(1), corner(2)});
  }
  return triangles;
}

// Distance of p from the segment ab, which may be a point.
inline double point_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const Vector3 ab = b - a;
  const double length = ab.norm();
  if (length == 0.0) return (p - a).norm();
  const double along = std::clamp((p - a).dot(ab) / length, 0.0, length);
  return (p - a - (along / length) * ab).norm();
}

// Distance of the segments ab and cd. The nearest points are either an end of one segment and a
// point of the other, or inner points of both; these are the feet of the common perpendicular, at
// the parameters s of ab and t of cd. Parallel segments (n = 0) always have the first case.
inline double segment_to_segment(const Vector3& a, const Vector3& b, const Vector3& c,
                                 const Vector3& d) {
  double least = std::min({point_to_segment(a, c, d), point_to_segment(b, c, d),
                           point_to_segment(c, a, b), point_to_segment(d, a, b)});
  const Vector3 n = (b - a).cross(d - c);
  const double squared = n.squaredNorm();
  if (squared == 0.0) return least;
  const double s = (c - a).cross(d - c).dot(n) / squared;
  const double t = (c - a).cross(b - a).dot(n) / squared;
  if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) {
    least = std::min(least, (a + s * (b - a) - c - t * (d - c)).norm());
  }
  return least;
}

// Whether the orthogonal projection of p onto the triangle's plane is inside the triangle, edges
// included: p is on the inner side of all three edges. `n` is the triangle's normal, of any length.
inline bool foot_is_inside(const Vector3& p, const Corners& t, const Vector3& n) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (n.dot((t[(k + 1) % 3] - t[k]).cross(p - t[k])) < 0.0) return false;
  }
  return true;
}

// Distance of p from the triangle t: to its edges, or to its plane where the projection is inside.
inline double point_to_triangle(const Vector3& p, const Corners& t) {
  double least = std::min({point_to_segment(p, t[0], t[1]), point_to_segment(p, t[1], t[2]),
                           point_to_segment(p, t[2], t[0])});
  const Vector3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  if (n.squaredNorm() > 0.0 && foot_is_inside(p, t, n)) {
    least = std::min(least, std::abs((p - t[0]).dot(n.normalized())));
  }
  return least;
}

// Whether the segment ab intersects the triangle t. A segment in the plane of the triangle is not
// counted: the quotient below would be 0 / 0.
inline bool segment_meets_triangle(const Vector3& a, const Vector3& b, const Corners& t) {
  const Vector3 n = (t[1] - t[0]).cross(t[2] - t[0]);
  const double above = (a - t[0]).dot(n);
  const double below = (b - t[0]).dot(n);
  if (above * below > 0.0 || above == below) return false;
  return foot_is_inside(a + (above / (above - below)) * (b - a), t, n);
}

// Whether the triangles intersect: then an edge of one passes through the other.
inline bool triangles_meet(const Corners& s, const Corners& t) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (segment_meets_triangle(s[k], s[(k + 1) % 3], t)) return true;
    if (segment_meets_triangle(t[k], t[(k + 1) % 3], s)) return true;
  }
  return false;
}

// Distance of two triangles, 0 where they intersect. The nearest points of disjoint triangles are a
// corner and a point of the other triangle, or on an edge of each.
inline double triangle_to_triangle(const Corners& s, const Corners& t) {
  if (triangles_meet(s, t)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min({least, point_to_triangle(s[k], t), point_to_triangle(t[k], s)});
    for (std::size_t m = 0; m < 3; ++m) {
      least = std::min(least, segment_to_segment(s[k], s[(k + 1) % 3], t[m], t[(m + 1) % 3]));
    }
  }
  return least;
}

// Axis-aligned bounding box of a triangle.
inline Bounds bounds_of(const Corners& t) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

// Distance between axis-aligned boxes: a lower bound of the distance between their contents.
inline double bounds_apart(const Bounds& a, const Bounds& b) {
  return (a.lower - b.upper).cwiseMax(b.lower - a.upper).cwiseMax(Vector3::Zero()).norm();
}

// Calls visit(i, k) for the pairs a[i], b[k] whose bounding boxes are at most `limit()` [m] apart.
// The limit is asked again for each pair, so that visits may lower it.
template <typename Limit, typename Visit>
void each_pair(const std::vector<Corners>& a, const std::vector<Corners>& b, const Limit& limit,
               const Visit& visit) {
  std::vector<Bounds> of_b;
  of_b.reserve(b.size());
  for (const Corners& t : b) of_b.push_back(bounds_of(t));
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Bounds of_a = bounds_of(a[i]);
    for (std::size_t k = 0; k < b.size(); ++k) {
      if (bounds_apart(of_a, of_b[k]) <= limit()) visit(i, k);
    }
  }
}

// Smallest distance between the surfaces, 0 where they meet.
inline double surface_gap(const std::vector<Corners>& a, const std::vector<Corners>& b) {
  double least = std::numeric_limits<double>::infinity();
  each_pair(
      a, b, [&] { return least; },
      [&](std::size_t i, std::size_t k) {
        least = std::min(least, triangle_to_triangle(a[i], b[k]));
      });
  return least;
}

// Whether any two triangles intersect. After the first such pair the limit is below every distance,
// which skips the remaining pairs.
inline bool surfaces_meet(const std::vector<Corners>& a, const std::vector<Corners>& b) {
  bool meet = false;
  each_pair(
      a, b, [&] { return meet ? -1.0 : 0.0; },
      [&](std::size_t i, std::size_t k) { meet = meet || triangles_meet(a[i], b[k]); });
  return meet;
}

// Smallest distance of p from the triangles.
inline double point_to_surface(const Vector3& p, const std::vector<Corners>& surface) {
  double least = std::numeric_limits<double>::infinity();
  for (const Corners& t : surface) least = std::min(least, point_to_triangle(p, t));
  return least;
}

// Winding number of the surface around p, by counting the signed crossings of a ray. The median of
// three rays is returned, because a ray through an edge may count it twice or not at all. > 0
// inside solids whose triangles face outward, 0 outside.
inline int winding(const Vector3& p, const std::vector<Corners>& surface) {
  const std::array<Vector3, 3> rays = {Vector3(0.31, 0.87, 0.39), Vector3(-0.77, 0.21, 0.61),
                                       Vector3(0.12, -0.59, -0.80)};
  std::array<int, 3> count = {};
  for (const Corners& t : surface) {
    const Vector3 n = (t[1] - t[0]).cross(t[2] - t[0]);
    for (std::size_t r = 0; r < rays.size(); ++r) {
      const double slope = rays[r].dot(n);
      const double along = (t[0] - p).dot(n);
      if (slope == 0.0 || along * slope < 0.0) continue;
      if (foot_is_inside(p + (along / slope) * rays[r], t, n)) count[r] += slope > 0.0 ? 1 : -1;
    }
  }
  std::sort(count.begin(), count.end());
  return count[1];
}

// Whether one solid is inside the other: used where the surfaces do not intersect, so that a
// single corner of a component tells where all of it is.
inline bool one_holds_the_other(const std::vector<Corners>& a, const std::vector<Corners>& b) {
  const auto holds = [](const std::vector<Corners>& outer, const std::vector<Corners>& inner) {
    return std::any_of(inner.begin(), inner.end(),
                       [&](const Corners& t) { return winding(t[0], outer) > 0; });
  };
  return holds(a, b) || holds(b, a);
}

}  // namespace prehend::test
