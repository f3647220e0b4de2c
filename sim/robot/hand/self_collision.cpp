#include "sim/robot/hand/self_collision.h"

#include <algorithm>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/link_pairs.h"

namespace prehend {

SelfCollision::SelfCollision(const Robot& robot) : robot_(robot), pairs_(checked_pairs(robot)) {
  for (const Link& link : robot.links) {
    require(!link.mesh.empty(), {robot.name, "link " + link.name, "has no triangles"});
    meshes_.emplace_back(link.mesh);
  }
}

std::vector<Pose> SelfCollision::poses_at(const std::vector<double>& dofs) const {
  std::vector<Pose> X_BL;
  link_poses(robot_, joint_values(robot_, dofs), X_BL);
  return X_BL;
}

bool SelfCollision::cross(int a, int b, const std::vector<Pose>& X_BL) const {
  return find_gap(meshes_[index(a)], meshes_[index(b)], X_BL[index(a)].inverse() * X_BL[index(b)],
                  {.cap = 1e-6, .hint = {}})
             .lower <= 0.0;
}

std::vector<std::pair<int, int>> SelfCollision::colliding(const std::vector<double>& dofs) const {
  const std::vector<Pose> X_BL = poses_at(dofs);
  std::vector<std::pair<int, int>> found;
  for (const auto& pair : pairs_) {
    if (cross(pair.first, pair.second, X_BL)) found.push_back(pair);
  }
  return found;
}

bool SelfCollision::any(const std::vector<double>& dofs) const {
  const std::vector<Pose> X_BL = poses_at(dofs);
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [&](const auto& pair) { return cross(pair.first, pair.second, X_BL); });
}

bool SelfCollision::meet(const std::vector<int>& a, const std::vector<int>& b,
                         const std::vector<double>& dofs) const {
  const std::vector<Pose> X_BL = poses_at(dofs);
  for (const int first : a) {
    for (const int second : b) {
      if (cross(first, second, X_BL)) return true;
    }
  }
  return false;
}

void SelfCollision::leave_out(const std::pair<int, int>& pair) { std::erase(pairs_, pair); }

}  // namespace prehend
