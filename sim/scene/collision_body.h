// Bodies for collision checks: links, the object and obstacles.
#pragma once

#include <string>
#include <vector>

#include "sim/base/pose.h"
#include "sim/shape/proximity_mesh.h"

namespace prehend {

// A surface mesh ready for gap and overlap queries.
struct CollisionBody {
  std::string name;
  ProximityMesh mesh;  // body frame
  // One vertex of each connected component of the surface, body frame. Where two surfaces do not
  // cross, each component lies wholly inside or wholly outside the other body, so that testing one
  // vertex of it is enough.
  std::vector<Vector3> probes;
  // Whether the surface encloses matter, so that another body can be inside. The object and the
  // obstacles are solid when their meshes are closed and oriented. Links always are: their meshes
  // stand for solid parts even where a file leaves small holes.
  bool is_solid = true;
};

// A body that does not move, in the reference frame R of the list it stands in: the object's frame
// O in CompiledScene::bodies, the base frame of the platform in CompiledArm::bodies.
struct PlacedBody : CollisionBody {
  Pose X_RB = Pose::Identity();
};

// Builds the search trees of `mesh` (in the body's frame, [m]). Throws InputError for a mesh
// without triangles, and Cancelled.
CollisionBody make_collision_body(std::string name, const TriangleMesh& mesh, bool is_solid,
                                  const RunContext& context = {});

// True when a component of one body lies inside the other, solid one. Only meaningful where the
// surfaces do not cross, which it does not check. `X_AB`: the pose of b's frame in a's.
bool one_contains_other(const CollisionBody& a, const CollisionBody& b, const Pose& X_AB);

// True when the surfaces cross or one body contains the other.
bool bodies_overlap(const CollisionBody& a, const CollisionBody& b, const Pose& X_AB);

// One vertex of each connected component of the mesh. Vertices of no triangle are left out.
std::vector<Vector3> component_vertices(const TriangleMesh& mesh);

}  // namespace prehend
