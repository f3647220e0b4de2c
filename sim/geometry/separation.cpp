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
#include "sim/geometry/separation.h"

#include <array>
#include <cmath>
#include <limits>

namespace prehend {
namespace {

// GJK needs few steps here; the limit only stops cycles caused by rounding.
constexpr int kMostSteps = 24;
// Stop when the lower bound reaches this fraction of the upper one. The bound only decides whether
// an exact query is needed, so that more steps do not pay.
constexpr double kGoodFraction = 0.9;

// Support function of the hull: the point that lies farthest along `direction`.
const Vector3& farthest(const ConvexPoints& set, const Vector3& direction) {
  const Vector3* best = nullptr;
  double most = -std::numeric_limits<double>::infinity();
  for (const Vector3& p : set.points) {
    const double along = p.dot(direction);
    if (along > most) {
      most = along;
      best = &p;
    }
  }
  return *best;
}

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

}  // namespace

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
    const Vector3 reach = X_AB * farthest(b, R_BA * -n) - farthest(a, n);
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
  return best - a.margin - b.margin;
}

}  // namespace prehend
