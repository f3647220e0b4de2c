// The links of a robot made ready for motions: trees, reaches, pairs that may touch.
#pragma once

#include <string>
#include <vector>

#include "sim/geometry/proximity.h"
#include "sim/scene/scene.h"

namespace prehend {

// A link with what bounds its motion.
struct CompiledLink {
  std::string name;
  ProximityMesh mesh;
  int joint = -1;                // -1: the base
  double friction = 0.0;         // against the object
  double compliant_depth = 0.0;  // by which it gives way to the object, 0: hard [m]
  // Joints before the link, base to tip, and for each the most that a point of the link can move
  // for a unit of the joint's motion: a reach in metres for revolute, 1 for prismatic.
  std::vector<int> joints;
  std::vector<double> reach;
  std::vector<Vector3> probes;  // one vertex of each of its components, link frame
};

// Two links that may touch each other.
struct LinkPair {
  int a = 0;
  int b = 0;
};

// All links of `robot`, with their friction against the object of the scene.
// Throws InputError for an unknown material or a link without triangles.
std::vector<CompiledLink> compile_links(const Scene& scene, const Robot& robot);

// All pairs but those that are rigid and those that overlap at a joint by construction: neighbours
// in a chain, and a chain's first link with what carries it.
std::vector<LinkPair> separate_pairs(const std::vector<CompiledLink>& links);

// One vertex of each connected component of the mesh.
std::vector<Vector3> component_vertices(const TriangleMesh& mesh);

}  // namespace prehend
