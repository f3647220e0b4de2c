// A scene made ready for trials: trees, reaches, friction, pairs to test. Immutable, shared by
// threads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/geometry/proximity.h"
#include "sim/quality/wrench.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/compiled_link.h"
#include "sim/scene/scene.h"

namespace prehend {

struct CompiledObstacle {
  std::string name;
  ProximityMesh mesh;
  Pose X_OB = Pose::Identity();      // the obstacle in the object's frame
  std::vector<Vector3> probes = {};  // one vertex of each of its components, its own frame
  bool is_solid = false;             // closed and oriented: inside has a meaning
};

struct CompiledScene {
  Scene scene;
  ProximityMesh object;
  std::vector<CompiledLink> links = {};  // as scene.hand.links
  std::vector<CompiledObstacle> obstacles = {};
  std::vector<LinkPair> self_pairs = {};
  // Per preshape of the hand and self pair, the gap at that preshape [m].
  std::vector<std::vector<double>> preshape_gaps = {};
  WrenchFrame wrench_frame = {};  // centre of mass; 1 / largest distance of a vertex from it
  std::vector<Vector3> object_probes = {};  // one vertex of each of its components
  bool object_is_solid = false;             // closed and oriented: inside has a meaning
  std::optional<CompiledArm> arm = {};      // where the scene has one

  bool has_obstacles() const { return !obstacles.empty(); }
};

// Throws InputError when the robot is not a hand, has an unknown material or an empty link, a
// preshape in which links collide, the object has no extent or overlaps an obstacle, or the arm's
// start posture collides or is outside limits.
CompiledScene compile(Scene scene);

}  // namespace prehend
