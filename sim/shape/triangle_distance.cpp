// A corner and a point inside a face are nearest where the corner is the nearest to the plane of
// the face, all corners being on one side, and its foot is inside the face: their distance is then
// that of the plane, which no pair of points can undercut. Otherwise the nearest points are on
// edges, unless an edge of one triangle crosses the face of the other.
#include "sim/shape/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <limits>

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

using Pairs = std::experimental::native_simd<double>;
constexpr std::size_t kPairs = Pairs::size();

// Vectors in lanes.
struct PairVector {
  Pairs x;
  Pairs y;
  Pairs z;
};

Pairs dot(const PairVector& a, const PairVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// The three edges of a triangle in lanes, by start and vector; the last edge fills up the lanes.
struct Edges {
  static constexpr std::size_t kCount = (3 + kPairs - 1) / kPairs * kPairs;
  using Components = std::array<std::array<double, kCount>, 3>;
  Components start;
  Components along;

  explicit Edges(const Corners& t) {
    for (std::size_t edge = 0; edge < kCount; ++edge) {
      const std::size_t k = std::min<std::size_t>(edge, 2);
      const Vector3 vector = t[(k + 1) % 3] - t[k];
      for (std::size_t i = 0; i < 3; ++i) {
        start[i][edge] = t[k][static_cast<Vector3::Index>(i)];
        along[i][edge] = vector[static_cast<Vector3::Index>(i)];
      }
    }
  }
};

PairVector load(const Edges::Components& from, std::size_t at) {
  using std::experimental::element_aligned;
  return {Pairs(from[0].data() + at, element_aligned), Pairs(from[1].data() + at, element_aligned),
          Pairs(from[2].data() + at, element_aligned)};
}

PairVector broadcast(const Vector3& v) { return {Pairs(v.x()), Pairs(v.y()), Pairs(v.z())}; }

// The parameters of the nearest points of edges p + s d and q + t e, 0 <= s, t <= 1, from the
// products of r = p - q, d and e. Ericson 2005, section 5.1.9: the feet of the common
// perpendicular, clamped to the first edge, then to the second, then to the first again. An edge
// without length is a point: its parameter is 0, as the numerator is. The denominator is 0 for
// parallel edges, for which any place on the first one will do. `Number`: double, or lanes of it.
template <typename Number>
struct EdgeParameters {
  Number s;
  Number t;

  EdgeParameters(const Number& dd, const Number& ee, const Number& de, const Number& dr,
                 const Number& er) {
    using std::max;
    using std::min;
    using std::experimental::max;
    using std::experimental::min;
    const Number tiny(std::numeric_limits<double>::min());
    const Number zero(0.0);
    const Number one(1.0);
    const Number denominator = max(dd * ee - de * de, tiny);
    s = max(zero, min((de * er - dr * ee) / denominator, one));
    t = max(zero, min((de * s + er) / max(ee, tiny), one));
    s = max(zero, min((de * t - dr) / max(dd, tiny), one));
  }
};

// The squared distances of edge p + s d from the edges q + t e.
Pairs squared_from_edges(const PairVector& p, const PairVector& d, const PairVector& q,
                         const PairVector& e) {
  const PairVector r{p.x - q.x, p.y - q.y, p.z - q.z};
  const EdgeParameters<Pairs> at(dot(d, d), dot(e, e), dot(d, e), dot(d, r), dot(e, r));
  const PairVector apart{r.x + at.s * d.x - at.t * e.x, r.y + at.s * d.y - at.t * e.y,
                         r.z + at.s * d.z - at.t * e.z};
  return dot(apart, apart);
}

// The nearest points of edge i of u and edge k of v.
NearestPoints nearest_on_edges(const Corners& u, std::size_t i, const Corners& v, std::size_t k) {
  const Vector3 d = u[(i + 1) % 3] - u[i];
  const Vector3 e = v[(k + 1) % 3] - v[k];
  const Vector3 r = u[i] - v[k];
  const EdgeParameters<double> at(d.squaredNorm(), e.squaredNorm(), d.dot(e), d.dot(r), e.dot(r));
  const Vector3 on_u = u[i] + at.s * d;
  const Vector3 on_v = v[k] + at.t * e;
  return {(on_u - on_v).norm(), on_u, on_v};
}

// The nearest points of all nine pairs of edges. What works on lanes is inlined: compilers call
// functions to fill them otherwise.
[[gnu::flatten]] NearestPoints nearest_edges(const Corners& u, const Corners& v) {
  const Edges edges(v);
  std::array<double, 3 * Edges::kCount> squared;
  for (std::size_t i = 0; i < 3; ++i) {
    const PairVector p = broadcast(u[i]);
    const PairVector d = broadcast(u[(i + 1) % 3] - u[i]);
    for (std::size_t at = 0; at < Edges::kCount; at += kPairs) {
      squared_from_edges(p, d, load(edges.start, at), load(edges.along, at))
          .copy_to(squared.data() + i * Edges::kCount + at, std::experimental::element_aligned);
    }
  }
  const auto least =
      static_cast<std::size_t>(std::min_element(squared.begin(), squared.end()) - squared.begin());
  return nearest_on_edges(u, least / Edges::kCount, v,
                          std::min<std::size_t>(least % Edges::kCount, 2));
}

}  // namespace

// The rounding error of the cross product turns the normal by about epsilon times the square of the
// longest edge over the area.
Vector3 reliable_normal(const std::array<Vector3, 3>& corners) {
  constexpr double kThinnest = 1e-8;
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
  if ((from_u == 0.0 && edge_crosses(u, over_u, v.corner)) ||
      (from_v == 0.0 && edge_crosses(v, over_v, u.corner))) {
    return {};
  }
  return nearest_edges(u.corner, v.corner);
}

}  // namespace prehend
