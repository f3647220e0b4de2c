// The links of a robot where it stands in the world.
#pragma once

#include <string>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

struct CollisionBody;
struct CompiledScene;
struct Scene;
struct Trial;

struct PosedLink {
  const CollisionBody* link = nullptr;  // of the scene, which must outlive it
  Pose X_WL = Pose::Identity();
};

// Of the hand in its grasp and, where the trial has its posture, of the arm that carries it.
std::vector<PosedLink> links_in_grasp(const CompiledScene& scene, const Trial& trial);

// Of the scene's platform at its start; none without one, for the hand is nowhere then.
std::vector<PosedLink> links_at_start(const CompiledScene& scene);

// Of the scene's platform, at the values of all of its joints.
std::vector<PosedLink> links_at(const CompiledScene& scene, const std::vector<double>& arm_joints);

// Whether no link of the one is within `distance` [m] of one of the other, nor inside it.
bool are_apart(const std::vector<PosedLink>& a, const std::vector<PosedLink>& b, double distance);

// Adds the links to the obstacles of a scene, each named after `robot`.
void add_obstacles(const std::vector<PosedLink>& links, const std::string& robot, Scene& scene);

}  // namespace prehend
