#include "sim/shape/triangle_mesh.h"

#include <algorithm>
#include <cmath>

namespace prehend {

Bounds bounds(const TriangleMesh& mesh) {
  Bounds box;
  for (const Vector3& p : mesh.vertices) {
    box.lower = box.lower.cwiseMin(p);
    box.upper = box.upper.cwiseMax(p);
  }
  return box;
}

Vector3 doubled_area_vector(const TriangleMesh& mesh, std::size_t t) {
  const Triangle& v = mesh.triangles[t];
  const Vector3& a = mesh.vertices[static_cast<std::size_t>(v[0])];
  const Vector3& b = mesh.vertices[static_cast<std::size_t>(v[1])];
  const Vector3& c = mesh.vertices[static_cast<std::size_t>(v[2])];
  return (b - a).cross(c - a);
}

double surface_area(const TriangleMesh& mesh) {
  double doubled = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    doubled += doubled_area_vector(mesh, t).norm();
  }
  return 0.5 * doubled;
}

TriangleMesh transformed(const TriangleMesh& mesh, const Pose& X_AB) {
  TriangleMesh moved = mesh;
  for (Vector3& p : moved.vertices) p = X_AB * p;
  return moved;
}

void append(TriangleMesh& mesh, const TriangleMesh& part) {
  const int shift = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (const Triangle& t : part.triangles) {
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
}

void append(TriangleMesh& mesh, const TriangleMesh& part, const Eigen::Affine3d& X_AB) {
  const std::size_t first_vertex = mesh.vertices.size();
  const std::size_t first_triangle = mesh.triangles.size();
  append(mesh, part);
  for (std::size_t i = first_vertex; i < mesh.vertices.size(); ++i) {
    mesh.vertices[i] = X_AB * mesh.vertices[i];
  }
  const bool mirrored = X_AB.linear().determinant() < 0.0;
  for (std::size_t t = first_triangle; mirrored && t < mesh.triangles.size(); ++t) {
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
}

double max_distance(const TriangleMesh& mesh, const Vector3& point) {
  double squared = 0.0;
  for (const Vector3& p : mesh.vertices) squared = std::max(squared, (p - point).squaredNorm());
  return std::sqrt(squared);
}

Corners corners_of(const TriangleMesh& mesh, int triangle) {
  const Triangle& v = mesh.triangles[static_cast<std::size_t>(triangle)];
  const auto vertex = [&](int k) { return mesh.vertices[static_cast<std::size_t>(k)]; };
  return {vertex(v[0]), vertex(v[1]), vertex(v[2])};
}

}  // namespace prehend
