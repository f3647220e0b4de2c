// A corner and a point inside a face are nearest where the corner is the nearest to the plane of
// the face, all corners being on one side, and its foot is inside the face: their distance is then
// that of the plane, which no pair of points can undercut. Otherwise the nearest points are on
// edges, unless an edge of one triangle crosses the face of the other.
#include "sim/shape/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "sim/base/wide_lanes.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {
namespace {

// The heights of three points over a plane.
struct Heights {
  std::array<double, 3> over{};

  Heights(const PlacedTriangle& plane, const Corners& points) {
    for (std::size_t k = 0; k < 3; ++k) over[k] = plane.normal.dot(points[k] - plane.corner[0]);
  }

  // The distance of the plane where all points are on one side of it, else 0.
  double distance() const {
    const double above = std::min({over[0], over[1], over[2]});
    const double below = -std::max({over[0], over[1], over[2]});
    return std::max({0.0, above, below});
  }

  std::size_t nearest() const {
    std::size_t least = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (std::abs(over[k]) < std::abs(over[least])) least = k;
    }
    return least;
  }
};

// Whether the foot of p on the triangle's plane is inside the triangle, edges included.
bool foot_is_inside(const PlacedTriangle& t, const Vector3& p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3& from = t.corner[k];
    const Vector3 along = t.corner[(k + 1) % 3] - from;
    if (t.normal.dot(along.cross(p - from)) < 0.0) return false;
  }
  return true;
}

// Whether an edge of `t` crosses or touches the face.
bool edge_crosses(const PlacedTriangle& face, const Heights& heights, const Corners& t) {
  if (face.normal.isZero(0.0)) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const double h0 = heights.over[k];
    const double h1 = heights.over[(k + 1) % 3];
    if (h0 == 0.0 && foot_is_inside(face, t[k])) return true;
    if (h0 * h1 > 0.0 || h0 == h1) continue;
    const Vector3 crossing = t[k] + (h0 / (h0 - h1)) * (t[(k + 1) % 3] - t[k]);
    if (foot_is_inside(face, crossing)) return true;
  }
  return false;
}

// Whether a plane is farther from the points, all on one side of it, than rounding of its normal
// could make it: that turns by 1e-7 at most (reliable_normal).
bool is_clear(double distance, const PlacedTriangle& plane, const Corners& points) {
  constexpr double kTurn = 1e-6;
  if (distance == 0.0) return false;
  double farthest = 0.0;
  for (const Vector3& p : points) {
    farthest = std::max(farthest, (p - plane.corner[0]).squaredNorm());
  }
  return distance * distance > kTurn * kTurn * farthest;
}

// Vectors in lanes.
struct LaneVector {
  Doubles4 x;
  Doubles4 y;
  Doubles4 z;
};

// The three edges of a triangle in lanes, by start and vector; the last edge fills up the lanes.
constexpr std::size_t kEdges = 4;

// Types as members: a template would forget how lanes are aligned.
struct OneDouble {
  using Type = double;
};
struct FourDoubles {
  using Type = Doubles4;
};

// The parameters of the nearest points of edges p + s d and q + t e, 0 <= s, t <= 1, from the
// products of r = p - q, d and e. Ericson 2005, section 5.1.9: the feet of the common
// perpendicular, clamped to the first edge, then to the second, then to the first again. An edge
// without length is a point: its parameter is 0, as the numerator is. The denominator is 0 for
// parallel edges, for which any place on the first one will do. `Numbers`: OneDouble,
// or FourDoubles.
template <typename Numbers>
struct EdgeParameters {
  using Number = typename Numbers::Type;

  Number s;
  Number t;

  [[gnu::always_inline]] EdgeParameters(const Number& dd, const Number& ee, const Number& de,
                                        const Number& dr, const Number& er) {
    const Number zero = {};
    const Number one = zero + 1.0;
    const Number tiny = zero + std::numeric_limits<double>::min();
    const Number square = dd * ee - de * de;
    const Number denominator = square > tiny ? square : tiny;
    const Number other = ee > tiny ? ee : tiny;
    const Number own = dd > tiny ? dd : tiny;
    s = (de * er - dr * ee) / denominator;
    clamp(zero, one, s);
    t = (de * s + er) / other;
    clamp(zero, one, t);
    s = (de * t - dr) / own;
    clamp(zero, one, s);
  }

 private:
  [[gnu::always_inline]] static void clamp(const Number& low, const Number& high, Number& number) {
    number = number < high ? number : high;
    number = number > low ? number : low;
  }
};

// The nearest points of edge i of u and edge k of v.
NearestPoints nearest_on_edges(const Corners& u, std::size_t i, const Corners& v, std::size_t k) {
  const Vector3 d = u[(i + 1) % 3] - u[i];
  const Vector3 e = v[(k + 1) % 3] - v[k];
  const Vector3 r = u[i] - v[k];
  const EdgeParameters<OneDouble> at(d.squaredNorm(), e.squaredNorm(), d.dot(e), d.dot(r),
                                     e.dot(r));
  const Vector3 on_u = u[i] + at.s * d;
  const Vector3 on_v = v[k] + at.t * e;
  return {(on_u - on_v).norm(), on_u, on_v};
}

// The squared distances of all pairs of edges: of edge i of u from edge k of v at 4 i + k.
[[gnu::always_inline]] inline void edge_distances_in(const Corners& u, const Corners& v,
                                                     std::array<double, 3 * kEdges>& squared) {
  LaneVector q;
  LaneVector e;
  for (std::size_t edge = 0; edge < kEdges; ++edge) {
    const std::size_t k = edge < 3 ? edge : 2;
    const std::size_t to = k < 2 ? k + 1 : 0;
    q.x[edge] = v[k].x();
    q.y[edge] = v[k].y();
    q.z[edge] = v[k].z();
    e.x[edge] = v[to].x() - v[k].x();
    e.y[edge] = v[to].y() - v[k].y();
    e.z[edge] = v[to].z() - v[k].z();
  }
  const Doubles4 ee = e.x * e.x + e.y * e.y + e.z * e.z;
  const Doubles4 zero = {};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3& from = u[i];
    const Vector3& to = u[i < 2 ? i + 1 : 0];
    const double d_x = to.x() - from.x();
    const double d_y = to.y() - from.y();
    const double d_z = to.z() - from.z();
    const Doubles4 dd = zero + (d_x * d_x + d_y * d_y + d_z * d_z);
    const LaneVector r{from.x() - q.x, from.y() - q.y, from.z() - q.z};
    const EdgeParameters<FourDoubles> at(dd, ee, d_x * e.x + d_y * e.y + d_z * e.z,
                                         d_x * r.x + d_y * r.y + d_z * r.z,
                                         e.x * r.x + e.y * r.y + e.z * r.z);
    const LaneVector apart{r.x + at.s * d_x - at.t * e.x, r.y + at.s * d_y - at.t * e.y,
                           r.z + at.s * d_z - at.t * e.z};
    const Doubles4 sum = apart.x * apart.x + apart.y * apart.y + apart.z * apart.z;
    std::memcpy(&squared[i * kEdges], &sum, sizeof(sum));
  }
}

PREHEND_FOR_AVX2 void edge_distances_with_avx2(const Corners& u, const Corners& v,
                                               std::array<double, 3 * kEdges>& squared) {
  edge_distances_in(u, v, squared);
}

// The nearest points of all nine pairs of edges.
NearestPoints nearest_edges(const Corners& u, const Corners& v) {
  std::array<double, 3 * kEdges> squared;
  if (has_avx2()) {
    edge_distances_with_avx2(u, v, squared);
  } else {
    edge_distances_in(u, v, squared);
  }
  const auto least =
      static_cast<std::size_t>(std::min_element(squared.begin(), squared.end()) - squared.begin());
  return nearest_on_edges(u, least / kEdges, v, std::min<std::size_t>(least % kEdges, 2));
}

}  // namespace

// The rounding error of the cross product turns the normal by about epsilon times the square of the
// longest edge over the area.
Vector3 reliable_normal(const std::array<Vector3, 3>& corners) {
  constexpr double kThinnest = 1e-7;
  const Vector3 e0 = corners[1] - corners[0];
  const Vector3 e1 = corners[2] - corners[0];
  const Vector3 area = e0.cross(e1);
  const double doubled = area.norm();
  const double longest =
      std::max({e0.squaredNorm(), e1.squaredNorm(), (corners[2] - corners[1]).squaredNorm()});
  return doubled > kThinnest * longest ? Vector3(area / doubled) : Vector3::Zero();
}

double plane_bound(const PlacedTriangle& u, const PlacedTriangle& v) {
  return std::max(Heights(u, v.corner).distance(), Heights(v, u.corner).distance());
}

NearestPoints triangle_distance(const PlacedTriangle& u, const PlacedTriangle& v) {
  const Heights over_u(u, v.corner);
  const double from_u = over_u.distance();
  if (from_u > 0.0) {
    const std::size_t k = over_u.nearest();
    const Vector3& corner = v.corner[k];
    if (foot_is_inside(u, corner)) return {from_u, corner - over_u.over[k] * u.normal, corner};
  }
  const Heights over_v(v, u.corner);
  const double from_v = over_v.distance();
  if (from_v > 0.0) {
    const std::size_t k = over_v.nearest();
    const Vector3& corner = u.corner[k];
    if (foot_is_inside(v, corner)) return {from_v, corner, corner - over_v.over[k] * v.normal};
  }
  // Triangles that cross have corners on both sides of both planes, or on them. Of triangles in
  // nearly one plane, rounding may put the corners of one to one side.
  if ((from_u == 0.0 && !is_clear(from_v, v, u.corner) && edge_crosses(u, over_u, v.corner)) ||
      (from_v == 0.0 && !is_clear(from_u, u, v.corner) && edge_crosses(v, over_v, u.corner))) {
    return {};
  }
  return nearest_edges(u.corner, v.corner);
}

}  // namespace prehend
