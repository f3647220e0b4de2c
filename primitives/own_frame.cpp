#include "primitives/own_frame.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace prehend {
namespace {

// Moments that differ by less than this, relative to the largest, cannot be told apart from
// rounding.
constexpr double kEqualMoments = 1e-7;
// The same of third moments, relative to area and size.
constexpr double kNoSkew = 1e-9;
// A vertex tells a direction where it is this far from the centre along it, relative to the size.
constexpr double kTelling = 1e-3;

struct Piece {
  Corners p;  // from a point near them: sums of powers of coordinates far from 0 would cancel
  double area = 0.0;
};

std::vector<Piece> pieces_about(const Vector3& origin, const TriangleMesh& mesh) {
  std::vector<Piece> pieces;
  pieces.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Piece piece{corners_of(mesh, static_cast<int>(t)), 0.5 * doubled_area_vector(mesh, t).norm()};
    for (Vector3& p : piece.p) p -= origin;
    pieces.push_back(piece);
  }
  return pieces;
}

// The integral of x^3 over the triangles, x the coordinate along a direction: of a triangle,
// area / 10 times the sum of all products of three of its corners' coordinates, in any order
// (the complete homogeneous polynomial).
double skew_along(const Vector3& direction, const std::vector<Piece>& triangles) {
  double skew = 0.0;
  for (const Piece& t : triangles) {
    const double a = direction.dot(t.p[0]);
    const double b = direction.dot(t.p[1]);
    const double c = direction.dot(t.p[2]);
    skew += t.area / 10.0 *
            (a * a * (a + b + c) + b * b * (a + b + c) + c * c * (a + b + c) + a * b * c);
  }
  return skew;
}

// Along `direction`, the side where there is more; where both are alike, that of the first corner
// that is not in the middle.
Vector3 with_sign(const Vector3& direction, const std::vector<Piece>& triangles, double area,
                  double size) {
  const double skew = skew_along(direction, triangles);
  if (std::abs(skew) > kNoSkew * area * size * size * size) {
    return std::copysign(1.0, skew) * direction;
  }
  for (const Piece& t : triangles) {
    for (const Vector3& p : t.p) {
      const double along = direction.dot(p);
      if (std::abs(along) > kTelling * size) return std::copysign(1.0, along) * direction;
    }
  }
  return direction;
}

// The direction orthogonal to `axis` (zero: any) in which the largest flat part of the surface
// faces: of a cube that of a face. Of equally large parts the first in the order of triangles.
Vector3 facing_most(const Vector3& axis, const std::vector<Piece>& triangles) {
  // The first large triangles are looked at, with all that are parallel to them.
  constexpr std::size_t kLooked = 32;
  constexpr double kLarge = 0.45;  // of the largest one's area; a half is a common value
  constexpr double kAcross = 0.5;  // least part of a normal that is orthogonal to the axis
  constexpr double kParallel = 1e-9;
  struct Facing {
    Vector3 direction;
    double area = 0.0;
  };
  std::vector<Facing> all;
  for (const Piece& t : triangles) {
    const Vector3 normal = (t.p[1] - t.p[0]).cross(t.p[2] - t.p[0]).normalized();
    const Vector3 across = normal - axis.dot(normal) * axis;
    if (across.norm() > kAcross) all.push_back({across.normalized(), t.area});
  }
  double largest = 0.0;
  for (const Facing& one : all) largest = std::max(largest, one.area);
  std::vector<Facing> looked_at;
  for (const Facing& one : all) {
    if (one.area > kLarge * largest && looked_at.size() < kLooked) looked_at.push_back(one);
  }
  Vector3 best = axis.isZero(0.0) ? Vector3(Vector3::UnitX()) : any_orthogonal(axis);
  double most = 0.0;
  for (const Facing& one : looked_at) {
    double area = 0.0;
    for (const Facing& other : all) {
      if (one.direction.cross(other.direction).squaredNorm() < kParallel) area += other.area;
    }
    if (area <= (1.0 + 1e-9) * most) continue;
    most = area;
    best = one.direction;
  }
  return best;
}

// Axes as columns, right-handed.
Matrix3 axes_of(const Matrix3& second, const std::vector<Piece>& triangles, double area,
                double size) {
  const Eigen::SelfAdjointEigenSolver<Matrix3> principal(second);
  const Vector3& moments = principal.eigenvalues();
  const bool low = moments[1] - moments[0] <= kEqualMoments * moments[2];
  const bool high = moments[2] - moments[1] <= kEqualMoments * moments[2];
  Vector3 x = principal.eigenvectors().col(0);
  Vector3 y = principal.eigenvectors().col(1);
  if (low && high) {
    x = facing_most(Vector3::Zero(), triangles);
    y = facing_most(x, triangles);
  } else if (low) {
    x = facing_most(principal.eigenvectors().col(2), triangles);
    y = with_sign(principal.eigenvectors().col(2).cross(x), triangles, area, size);
  } else {
    x = with_sign(x, triangles, area, size);
    y = high ? facing_most(x, triangles) : with_sign(y, triangles, area, size);
  }
  Matrix3 axes;
  axes << x, y, x.cross(y);
  return axes;
}

}  // namespace

OwnFrame own_frame(const TriangleMesh& mesh) {
  OwnFrame own;
  if (mesh.empty()) return own;
  const Vector3 near = mesh.vertices[static_cast<std::size_t>(mesh.triangles.front()[0])];
  std::vector<Piece> triangles = pieces_about(near, mesh);
  double area = 0.0;
  Vector3 first = Vector3::Zero();
  for (const Piece& t : triangles) {
    area += t.area;
    first += t.area / 3.0 * (t.p[0] + t.p[1] + t.p[2]);
  }
  if (!(area > 0.0)) return own;
  const Vector3 center = first / area;
  double size = 0.0;
  Matrix3 second = Matrix3::Zero();
  for (Piece& t : triangles) {
    for (Vector3& p : t.p) {
      p -= center;
      size = std::max(size, p.norm());
    }
    const Vector3 sum = t.p[0] + t.p[1] + t.p[2];
    second += t.area / 12.0 * (sum * sum.transpose());
    for (const Vector3& p : t.p) second += t.area / 12.0 * (p * p.transpose());
  }
  own.X_OA = pose_from(axes_of(second, triangles, area, size), near + center);
  Bounds around;
  for (const Piece& t : triangles) {
    for (const Vector3& p : t.p) {
      const Vector3 p_A = own.X_OA.linear().transpose() * p;
      around.lower = around.lower.cwiseMin(p_A);
      around.upper = around.upper.cwiseMax(p_A);
    }
  }
  own.center_A = around.center();
  own.diagonal = around.diagonal();
  return own;
}

}  // namespace prehend
