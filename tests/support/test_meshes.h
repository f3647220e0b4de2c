// Small meshes and comparisons that several tests of the folder use.
#pragma once

#include <gtest/gtest.h>

#include "sim/geometry/basic_shapes.h"
#include "sim/geometry/mesh_checks.h"
#include "sim/geometry/triangle_mesh.h"

namespace prehend::test {

inline TriangleMesh moved(const TriangleMesh& mesh, const Vector3& by) {
  return transformed(mesh, translation(by));
}

inline TriangleMesh turned_over(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Vector3& p : mesh.vertices) p *= factor;
  return mesh;
}

// V - E + F of a closed mesh whose vertices are all used: 2 - 2 genus for one component.
inline int euler_characteristic(const TriangleMesh& mesh) {
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size()) / 2;
}

inline void expect_outward_solid(const TriangleMesh& mesh) {
  const MeshChecks checks = check_mesh(mesh);
  EXPECT_TRUE(checks.solid()) << checks.boundary_edges << " boundary, " << checks.nonmanifold_edges
                              << " non-manifold, " << checks.misoriented_edges << " misoriented";
  EXPECT_FALSE(checks.inward);
  EXPECT_EQ(checks.degenerate_triangles, 0);
  EXPECT_EQ(checks.components, 1);
}

// Squared longest side over twice the area: 1.15 for an equilateral triangle, 10 for a sliver of
// about 1:10.
inline double worst_aspect(const TriangleMesh& mesh) {
  double worst = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    double longest = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& a = mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][k])];
      const Vector3& b = mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][(k + 1) % 3])];
      longest = std::max(longest, (b - a).squaredNorm());
    }
    worst = std::max(worst, longest / doubled_area_vector(mesh, t).norm());
  }
  return worst;
}

}  // namespace prehend::test
