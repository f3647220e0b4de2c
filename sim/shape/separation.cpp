// GJK (Gilbert, Johnson and Keerthi 1988) on the set of differences b - a, whose distance from the
// origin is the distance between the convex sets. Each step asks for the point of that set farthest
// towards the origin (by the support functions of a and b), adds it to a simplex of at most four
// points, and continues with the point of the simplex nearest to the origin, whose direction is the
// next direction of search.
//
// Each support point gives a lower bound: the set lies beyond the plane through it with normal n.
// The nearest point of the simplex gives an upper bound. The search ends when the two are close
// enough. Only the lower bound is returned, so errors in the simplex (rounding, nearly flat
// tetrahedra) can make the result smaller but never wrong.
#include "sim/shape/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/base/wide_lanes.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {
namespace {

// GJK needs few steps here; the limit only stops cycles caused by rounding.
constexpr int kMostSteps = 24;
// Stop when the lower bound reaches this fraction of the upper one. The bound only decides whether
// an exact query is needed, so that more steps do not pay.
constexpr double kGoodFraction = 0.9;

// Up to four points of the set b - a, the first `size` of `point`.
struct Simplex {
  std::array<Vector3, 4> point;
  std::size_t size = 0;
};

// Each nearest_on_... returns the point of the simplex nearest to the origin and reduces `s` to the
// part of it (vertex, edge or triangle) that contains this point.
Vector3 nearest_on_segment(Simplex& s) {
  const Vector3 ab = s.point[1] - s.point[0];
  const double t = -s.point[0].dot(ab) / ab.squaredNorm();
  if (!(t > 0.0)) {
    s.size = 1;
    return s.point[0];
  }
  if (t >= 1.0) {
    s.point[0] = s.point[1];
    s.size = 1;
    return s.point[0];
  }
  return s.point[0] + t * ab;
}

// The nearest point on the three edges of a triangle.
Vector3 nearest_on_edges(Simplex& s) {
  Vector3 best;
  Simplex kept;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    Simplex edge{{s.point[k], s.point[(k + 1) % 3], Vector3::Zero(), Vector3::Zero()}, 2};
    const Vector3 p = nearest_on_segment(edge);
    if (p.squaredNorm() < least) {
      least = p.squaredNorm();
      best = p;
      kept = edge;
    }
  }
  s = kept;
  return best;
}

// The origin projects into the triangle when it is on the inner side of all three edges; otherwise,
// and for triangles without area, the nearest point is on an edge.
Vector3 nearest_on_triangle(Simplex& s) {
  const Vector3& a = s.point[0];
  const Vector3& b = s.point[1];
  const Vector3& c = s.point[2];
  const Vector3 n = (b - a).cross(c - a);
  const double squared = n.squaredNorm();
  const bool inside = squared > 0.0 && n.dot(a.cross(b)) >= 0.0 && n.dot(b.cross(c)) >= 0.0 &&
                      n.dot(c.cross(a)) >= 0.0;
  if (!inside) return nearest_on_edges(s);
  return n * (a.dot(n) / squared);
}

// The nearest point on the faces that have the origin on their outer side. When there is no such
// face the origin is inside: the result is zero, all four points are kept, and the sets intersect.
Vector3 nearest_on_tetrahedron(Simplex& s) {
  Vector3 best = Vector3::Zero();
  Simplex kept = s;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 4; ++k) {
    Simplex face{
        {s.point[(k + 1) % 4], s.point[(k + 2) % 4], s.point[(k + 3) % 4], Vector3::Zero()}, 3};
    const Vector3 n = (face.point[1] - face.point[0]).cross(face.point[2] - face.point[0]);
    // Signed distances (times |n|) of the fourth point and of the origin from the plane of the
    // face.
    const double opposite = n.dot(s.point[k] - face.point[0]);
    const double origin = -n.dot(face.point[0]);
    if (opposite * origin > 0.0) continue;  // the origin is on the inner side of this face
    const Vector3 p = nearest_on_triangle(face);
    if (p.squaredNorm() < least) {
      least = p.squaredNorm();
      best = p;
      kept = face;
    }
  }
  s = kept;
  return best;
}

Vector3 nearest_to_origin(Simplex& s) {
  switch (s.size) {
    case 1:
      return s.point[0];
    case 2:
      return nearest_on_segment(s);
    case 3:
      return nearest_on_triangle(s);
    default:
      return nearest_on_tetrahedron(s);
  }
}

// A block: the coordinates x of so many points, then y, then z.
constexpr std::size_t kBlock = 8;

// The number of the point that lies farthest along d. Each lane keeps the largest value it has seen
// and in which block; of equal ones, the first.
[[gnu::always_inline]] inline std::size_t farthest_in(const std::vector<float>& blocks,
                                                      const std::array<float, 3>& d) {
  const Floats8 zero = {};
  const Floats8 dx = zero + d[0];
  const Floats8 dy = zero + d[1];
  const Floats8 dz = zero + d[2];
  Floats8 most = zero - std::numeric_limits<float>::infinity();
  Ints8 at = {};
  Ints8 number = {};  // of the block
  const float* const end = blocks.data() + blocks.size();
  for (const float* block = blocks.data(); block != end; block += 3 * kBlock) {
    Floats8 x;
    Floats8 y;
    Floats8 z;
    std::memcpy(&x, block, sizeof(x));
    std::memcpy(&y, block + kBlock, sizeof(y));
    std::memcpy(&z, block + 2 * kBlock, sizeof(z));
    const Floats8 along = dx * x + dy * y + dz * z;
    const Ints8 farther = along > most;
    at = farther ? number : at;
    most = farther ? along : most;
    number += 1;
  }
  // Of lanes with equal values one of the first half, and there the first.
  constexpr std::size_t kHalf = kBlock / 2;
  std::array<std::size_t, kHalf> best;
  for (std::size_t i = 0; i < kHalf; ++i) best[i] = most[i + kHalf] > most[i] ? i + kHalf : i;
  std::size_t lane = best[0];
  for (std::size_t i = 1; i < kHalf; ++i) {
    if (most[best[i]] > most[lane]) lane = best[i];
  }
  return kBlock * static_cast<std::size_t>(at[lane]) + lane;
}

PREHEND_FOR_AVX2 std::size_t farthest_with_avx2(const std::vector<float>& blocks,
                                                const std::array<float, 3>& d) {
  return farthest_in(blocks, d);
}

}  // namespace

ConvexPoints::ConvexPoints(std::vector<Vector3> points, double margin)
    : points_(std::move(points)), margin_(margin) {
  // Coordinates from the centre are small, and so are their rounding errors. A sum of three
  // products of numbers that were rounded themselves is off by at most 8 half units in the last
  // place of sqrt(3) radii; two such sums are compared.
  Bounds box;
  for (const Vector3& p : points_) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  const Vector3 center = box.center();
  double radius = 0.0;
  for (const Vector3& p : points_) radius = std::max(radius, (p - center).norm());
  search_error_ = 32.0 * 0.5 * std::numeric_limits<float>::epsilon() * radius;
  // The last block is filled up with the first point.
  const std::size_t blocks = (points_.size() + kBlock - 1) / kBlock;
  blocks_.resize(3 * kBlock * blocks);
  for (std::size_t i = 0; i < blocks * kBlock; ++i) {
    const Vector3 p = points_[i < points_.size() ? i : 0] - center;
    for (std::size_t k = 0; k < 3; ++k) {
      blocks_[(3 * (i / kBlock) + k) * kBlock + i % kBlock] =
          static_cast<float>(p[static_cast<Vector3::Index>(k)]);
    }
  }
}

const Vector3& ConvexPoints::farthest(const Vector3& direction) const {
  const std::array<float, 3> d{static_cast<float>(direction.x()), static_cast<float>(direction.y()),
                               static_cast<float>(direction.z())};
  const std::size_t found = has_avx2() ? farthest_with_avx2(blocks_, d) : farthest_in(blocks_, d);
  return points_[found < points_.size() ? found : 0];
}

double separation(const ConvexPoints& a, const ConvexPoints& b, const Pose& X_AB,
                  Vector3& direction) {
  const Matrix3 R_BA = X_AB.linear().transpose();
  double best = -std::numeric_limits<double>::infinity();
  Vector3 n = direction.squaredNorm() > 0.0 ? direction : X_AB.translation();
  if (n.squaredNorm() == 0.0) n = Vector3::UnitX();
  Simplex simplex;
  for (int step = 0; step < kMostSteps; ++step) {
    n.normalize();
    // The support point of b - a against n: the smallest value of n . (b - a) over the whole set.
    const Vector3 reach = X_AB * b.farthest(R_BA * -n) - a.farthest(n);
    const double bound = n.dot(reach);
    if (bound > best) {
      best = bound;
      direction = n;
    }
    simplex.point[simplex.size++] = reach;
    n = nearest_to_origin(simplex);
    const double upper = n.norm();
    // Four kept points, or a nearest point of length 0: the origin is in the set, the hulls
    // intersect.
    if (!(upper > 0.0) || simplex.size == 4 || best >= kGoodFraction * upper) break;
  }
  return best - a.margin() - b.margin() - a.search_error() - b.search_error();
}

}  // namespace prehend
