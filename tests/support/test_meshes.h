// Changed copies of meshes, and checks of meshes, that several tests use.
#pragma once

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
#include "sim/shape/mesh_checks.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::test {

// The mesh moved by a vector.
inline TriangleMesh moved(const TriangleMesh& mesh, const Vector3& by) {
  return transformed(mesh, translation(by));
}

// The mesh with all triangles reversed, so that an outward surface faces inward.
inline TriangleMesh turned_over(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

// The mesh scaled about the origin.
inline TriangleMesh scaled(TriangleMesh mesh, double factor) {
  for (Vector3& p : mesh.vertices) p *= factor;
  return mesh;
}

// Euler characteristic V - E + F of a closed mesh whose vertices are all used: 2 - 2 * genus for
// one component. Each triangle has three edges that it shares with one other, so E = 3 F / 2.
inline int euler_characteristic(const TriangleMesh& mesh) {
  return static_cast<int>(mesh.vertices.size()) - static_cast<int>(mesh.triangles.size()) / 2;
}

// Expects one closed component that faces outward, without degenerate triangles.
inline void expect_outward_solid(const TriangleMesh& mesh) {
  const MeshChecks checks = check_mesh(mesh);
  EXPECT_TRUE(checks.solid()) << checks.boundary_edges << " boundary, " << checks.nonmanifold_edges
                              << " non-manifold, " << checks.misoriented_edges << " misoriented";
  EXPECT_FALSE(checks.inward);
  EXPECT_EQ(checks.degenerate_triangles, 0);
  EXPECT_EQ(checks.components, 1);
}

// The largest aspect ratio of the triangles: the squared longest side divided by twice the
// area. 1.15 for an equilateral triangle, 10 for one ten times as long as wide.
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
