#include "sim/scene/collision_body.h"

#include <algorithm>
#include <utility>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"
#include "sim/shape/proximity.h"

// Two bodies overlap where their surfaces cross, or where one body is inside the other. Where the
// surfaces do not cross, each connected component of one is wholly inside or wholly outside the
// other body, so that one vertex of each component (probes) decides about the second case.
namespace prehend {
namespace {

// Whether any of the points, given in a frame with the pose X in the mesh's, is inside the mesh.
bool any_inside(const ProximityMesh& mesh, const std::vector<Vector3>& points, const Pose& X) {
  return std::any_of(points.begin(), points.end(),
                     [&](const Vector3& p) { return is_inside(mesh, X * p); });
}

// Whether the bounding balls are apart: a cheap test that answers most queries.
bool balls_apart(const ProximityMesh& a, const ProximityMesh& b, const Pose& X_AB) {
  const double apart = (X_AB * b.ball_center() - a.ball_center()).norm();
  return apart > a.ball_radius() + b.ball_radius();
}

bool has_component_inside(const CollisionBody& a, const CollisionBody& b, const Pose& X_AB) {
  return (a.is_solid && any_inside(a.mesh, b.probes, X_AB)) ||
         (b.is_solid && any_inside(b.mesh, a.probes, X_AB.inverse()));
}

}  // namespace

CollisionBody make_collision_body(std::string name, const TriangleMesh& mesh, bool is_solid,
                                  const RunContext& context) {
  return {std::move(name), ProximityMesh(mesh, context), component_vertices(mesh), is_solid};
}

bool one_contains_other(const CollisionBody& a, const CollisionBody& b, const Pose& X_AB) {
  return !balls_apart(a.mesh, b.mesh, X_AB) && has_component_inside(a, b, X_AB);
}

bool bodies_overlap(const CollisionBody& a, const CollisionBody& b, const Pose& X_AB) {
  if (balls_apart(a.mesh, b.mesh, X_AB)) return false;
  return surfaces_cross(a.mesh, b.mesh, X_AB) || has_component_inside(a, b, X_AB);
}

std::vector<Vector3> component_vertices(const TriangleMesh& mesh) {
  DisjointSets sets(mesh.vertices.size());
  for (const Triangle& t : mesh.triangles) {
    sets.merge(index(t[0]), index(t[1]));
    sets.merge(index(t[0]), index(t[2]));
  }
  std::vector<bool> known(mesh.vertices.size(), false);
  std::vector<Vector3> vertices;
  for (const Triangle& t : mesh.triangles) {  // a vertex of no triangle is no part of the surface
    const std::size_t component = sets.find(index(t[0]));
    if (!known[component]) vertices.push_back(mesh.vertices[index(t[0])]);
    known[component] = true;
  }
  return vertices;
}

}  // namespace prehend
