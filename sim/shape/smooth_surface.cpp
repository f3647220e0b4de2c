#include "sim/shape/smooth_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"
#include "sim/shape/proximity.h"
#include "sim/shape/weld.h"

namespace prehend {
namespace {

// Faces that meet at a larger angle meet at a crease [rad].
constexpr double kCrease = 0.6;
// Points nearer than this to an edge or a corner are on it [m].
constexpr double kOnFeature = 1e-7;
// A surface that curves less than a ball of this radius is even but for unevenness [m].
constexpr double kLargestRadius = 0.25;
// A surface that turns away from `outward` by more than this has an edge there [rad].
constexpr double kSharp = 0.35;

using CornerNormals = std::array<Vector3, 3>;

Vector3 normal_of(const TriangleMesh& mesh, int t) {
  const Corners c = corners_of(mesh, t);
  const Vector3 area = (c[1] - c[0]).cross(c[2] - c[0]);
  const double size = area.norm();
  return size > 0.0 ? Vector3(area / size) : Vector3::Zero();
}

double angle_at(const Corners& c, std::size_t k) {
  const Vector3 u = c[(k + 1) % 3] - c[k];
  const Vector3 v = c[(k + 2) % 3] - c[k];
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

std::size_t corner_at(const TriangleMesh& mesh, int t, int vertex) {
  const Triangle& triangle = mesh.triangles[index(t)];
  return static_cast<std::size_t>(std::find(triangle.begin(), triangle.end(), vertex) -
                                  triangle.begin());
}

bool share_edge(const Triangle& a, const Triangle& b) {
  const auto shared = std::count_if(
      a.begin(), a.end(), [&](int v) { return std::find(b.begin(), b.end(), v) != b.end(); });
  return shared >= 2;
}

// The normals of the groups of faces around a vertex, weighted by their angles there.
void set_normals_at(const ProximityMesh& mesh, int vertex, const std::vector<Vector3>& faces,
                    std::vector<CornerNormals>& normals) {
  const auto around = mesh.triangles_at(vertex);
  DisjointSets groups(around.size());
  for (std::size_t i = 0; i < around.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Vector3& a = faces[index(around[i])];
      const Vector3& b = faces[index(around[k])];
      if (a.dot(b) < std::cos(kCrease)) continue;
      const std::vector<Triangle>& triangles = mesh.mesh().triangles;
      if (share_edge(triangles[index(around[i])], triangles[index(around[k])])) groups.merge(i, k);
    }
  }
  std::vector<Vector3> sums(around.size(), Vector3::Zero());
  for (std::size_t i = 0; i < around.size(); ++i) {
    const std::size_t corner = corner_at(mesh.mesh(), around[i], vertex);
    sums[groups.find(i)] +=
        angle_at(corners_of(mesh.mesh(), around[i]), corner) * faces[index(around[i])];
  }
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Vector3& sum = sums[groups.find(i)];
    if (!(sum.norm() > 0.0)) continue;
    normals[index(around[i])][corner_at(mesh.mesh(), around[i], vertex)] = sum.normalized();
  }
}

// How far the surface is above the middle of the edge that begins at corner k.
double sag_of(const Corners& c, const CornerNormals& n, std::size_t k) {
  const std::size_t next = (k + 1) % 3;
  return 0.125 * (c[k] - c[next]).dot(n[k] - n[next]);
}

// Weights of the corners at a point of the triangle.
Vector3 weights_at(const Corners& c, const Vector3& p) {
  const Vector3 area = (c[1] - c[0]).cross(c[2] - c[0]);
  const double size = area.squaredNorm();
  Vector3 weights;
  for (std::size_t k = 0; k < 3; ++k) {
    weights[static_cast<Eigen::Index>(k)] =
        area.dot((c[(k + 2) % 3] - c[(k + 1) % 3]).cross(p - c[(k + 1) % 3])) / size;
  }
  weights = weights.cwiseMax(0.0);
  return weights / weights.sum();
}

// The symmetric tensor in the plane of the triangle that turns the ways between its corners into
// the changes of their normals, by least squares.
Matrix3 curvature_of(const Corners& c, const CornerNormals& n, const Vector3& normal) {
  const Vector3 x = (c[1] - c[0]).normalized();
  const Vector3 y = normal.cross(x);
  if (n[0] == n[1] && n[0] == n[2]) return Matrix3::Zero();
  Matrix3 sum = Matrix3::Zero();
  Vector3 right = Vector3::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 way = c[(k + 1) % 3] - c[k];
    const Vector3 change = n[(k + 1) % 3] - n[k];
    const double u = way.dot(x);
    const double v = way.dot(y);
    // (a u + b v, b u + d v) for the tensor ((a, b), (b, d)).
    const Vector3 first(u, v, 0.0);
    const Vector3 second(0.0, u, v);
    sum += first * first.transpose() + second * second.transpose();
    right += change.dot(x) * first + change.dot(y) * second;
  }
  const Vector3 abd = sum.ldlt().solve(right);
  return abd[0] * x * x.transpose() + abd[1] * (x * y.transpose() + y * x.transpose()) +
         abd[2] * y * y.transpose();
}

// Calls `look` with the triangles around p, a point of triangle t, besides t: where p is a corner
// those that share it, where it is on an edge those that share that.
template <typename Look>
void look_around(const ProximityMesh& proximity, int t, const Vector3& p, const Look& look) {
  const TriangleMesh& mesh = proximity.mesh();
  const Triangle& triangle = mesh.triangles[index(t)];
  const Corners c = corners_of(mesh, t);
  const auto look_at = [&](int u) {
    if (u != t && !is_degenerate(mesh, index(u))) look(u);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if ((p - c[k]).norm() > kOnFeature) continue;
    for (const int u : proximity.triangles_at(triangle[k])) look_at(u);
    return;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3 way = c[(k + 1) % 3] - c[k];
    if (way.cross(p - c[k]).norm() > kOnFeature * way.norm()) continue;
    const int other_end = triangle[(k + 1) % 3];
    for (const int u : proximity.triangles_at(triangle[k])) {
      const Triangle& beside = mesh.triangles[index(u)];
      if (std::find(beside.begin(), beside.end(), other_end) != beside.end()) look_at(u);
    }
    return;
  }
}

}  // namespace

SmoothSurface smooth_surface(const ProximityMesh& proximity) {
  const TriangleMesh& mesh = proximity.mesh();
  const auto triangles = static_cast<int>(mesh.triangles.size());
  std::vector<Vector3> faces;
  for (int t = 0; t < triangles; ++t) faces.push_back(normal_of(mesh, t));
  SmoothSurface surface;
  for (const Vector3& face : faces) surface.normals.push_back({face, face, face});
  for (int v = 0; v < static_cast<int>(mesh.vertices.size()); ++v) {
    set_normals_at(proximity, v, faces, surface.normals);
  }
  for (int t = 0; t < triangles; ++t) {
    const Corners c = corners_of(mesh, t);
    CornerNormals& n = surface.normals[index(t)];
    double sag = 0.0;
    double curvature = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (c[(k + 1) % 3] - c[k]).norm();
      sag = std::max(sag, std::abs(sag_of(c, n, k)));
      curvature = std::max(curvature, 8.0 * std::abs(sag_of(c, n, k)) / (length * length));
    }
    const bool is_curved = curvature > 1.0 / kLargestRadius && sag <= kMostSag;
    if (!is_curved) n = {faces[index(t)], faces[index(t)], faces[index(t)]};
    surface.is_curved = surface.is_curved || is_curved;
  }
  return surface;
}

SmoothPoint smooth_point(const ProximityMesh& proximity, int t, const Vector3& p,
                         const Vector3& outward) {
  const TriangleMesh& mesh = proximity.mesh();
  const SmoothSurface& surface = proximity.smooth();
  SmoothPoint best;
  double along = -2.0;
  const auto look = [&](int u) {
    const Corners c = corners_of(mesh, u);
    const CornerNormals& n = surface.normals[index(u)];
    const Vector3 weights = weights_at(c, p);
    const Vector3 normal = weights[0] * n[0] + weights[1] * n[1] + weights[2] * n[2];
    if (!(normal.norm() > 0.0)) return;
    const double now = normal.normalized().dot(outward);
    if (now <= along) return;
    along = now;
    best = {};
    best.normal = normal.normalized();
    best.curvature = curvature_of(c, n, normal_of(mesh, u));
    bool is_hollow = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3 way = c[(k + 1) % 3] - c[k];
      best.reach = std::max(best.reach, way.norm());
      best.height += 0.5 * weights[static_cast<Eigen::Index>(k)] * (c[k] - p).dot(n[k]);
      is_hollow = is_hollow || sag_of(c, n, k) < -1e-2 * kMostSag;
    }
    if (is_hollow) best.height += kMostSag;
  };
  if (!is_degenerate(mesh, index(t))) look(t);
  look_around(proximity, t, p, look);
  best.is_sharp = along < std::cos(kSharp);
  return best;
}

}  // namespace prehend
