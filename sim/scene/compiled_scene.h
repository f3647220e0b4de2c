// A scene made ready for trials: trees, reaches, friction, pairs to test. Immutable, shared by
// threads.
#pragma once

#include <memory>
#include <vector>

#include "sim/geometry/proximity.h"
#include "sim/quality/wrench.h"
#include "sim/scene/scene.h"

namespace prehend {

// A link of the hand with what bounds its motion.
struct CompiledLink {
  std::string name;
  ProximityMesh mesh;
  int joint = -1;                // -1: the palm
  double friction = 0.0;         // against the object
  double compliant_depth = 0.0;  // by which it gives way to the object, 0: hard [m]
  // Joints before the link, base to tip, and for each the most that a point of the link can move
  // for a unit of the joint's motion: a reach in metres for revolute, 1 for prismatic.
  std::vector<int> joints;
  std::vector<double> reach;
  std::vector<Vector3> probes;  // one vertex of each of its components, link frame
};

struct CompiledObstacle {
  std::string name;
  ProximityMesh mesh;
  Pose X_OB = Pose::Identity();      // the obstacle in the object's frame
  std::vector<Vector3> probes = {};  // one vertex of each of its components, its own frame
  bool is_solid = false;             // closed and oriented: inside has a meaning
};

// Two links of the hand that may touch each other while it closes.
struct LinkPair {
  int a = 0;
  int b = 0;
};

struct CompiledScene {
  Scene scene;
  ProximityMesh object;
  std::vector<CompiledLink> links;  // as scene.hand.links
  std::vector<CompiledObstacle> obstacles;
  std::vector<LinkPair> self_pairs;
  // Per preshape of the hand and self pair, the gap at that preshape [m].
  std::vector<std::vector<double>> preshape_gaps;
  WrenchFrame wrench_frame;            // centre of mass; 1 / largest distance of a vertex from it
  std::vector<Vector3> object_probes;  // one vertex of each of its components
  bool object_is_solid = false;        // closed and oriented: inside has a meaning

  bool has_obstacles() const { return !obstacles.empty(); }
};

// Throws InputError when the robot is not a hand, has an unknown material or an empty link, a
// preshape in which links collide, or the object has no extent.
CompiledScene compile(Scene scene);

}  // namespace prehend
