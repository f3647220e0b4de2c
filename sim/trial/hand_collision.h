// Collisions of the hand with the object and the obstacles.
#pragma once

#include <optional>
#include <vector>

#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"

namespace prehend {

// Buffers of hand_collision, to allocate less; one for each thread.
struct HandCollisionWorkspace {
  RobotPoses poses;
  NearBodies near;
};

// Which bodies the hand is looked for in.
enum class CollisionScope { all, object, obstacles };

// The first link, in the order of the hand's links, that overlaps the object or an obstacle with
// the hand's base at X_OH and its joints at `joints` [rad or m]; nothing where no link does.
// Collisions between links of the hand are not checked.
std::optional<HandContact> hand_collision(const CompiledScene& scene, const Pose& X_OH,
                                          const std::vector<double>& joints,
                                          HandCollisionWorkspace& workspace);

// The same with given poses of the links relative to the base, among some of the bodies.
std::optional<HandContact> hand_collision(const CompiledScene& scene, const Pose& X_OH,
                                          const RobotPoses& poses, CollisionScope among,
                                          NearBodies& near);

}  // namespace prehend
