// Measures of a hand at given degrees of freedom, from its joints and meshes alone.
#pragma once

#include <string>
#include <vector>

#include "sim/robot/link_pairs.h"
#include "sim/robot/robot.h"
#include "sim/shape/proximity.h"

namespace prehend::test {

inline std::vector<Pose> poses_at(const Robot& robot, const std::vector<double>& dofs) {
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, dofs), X_BL);
  return X_BL;
}

// Names of links that are checked against each other and cross: "a-b c-d", "" when there are none.
inline std::string self_collisions(const Robot& robot, const std::vector<double>& dofs) {
  const std::vector<Pose> X_BL = poses_at(robot, dofs);
  std::vector<ProximityMesh> meshes;
  for (const Link& link : robot.links) meshes.emplace_back(link.mesh);
  std::string crossing;
  for (const auto& [first, second] : checked_pairs(robot)) {
    const auto a = static_cast<std::size_t>(first);
    const auto b = static_cast<std::size_t>(second);
    if (!surfaces_cross(meshes[a], meshes[b], X_BL[a].inverse() * X_BL[b])) continue;
    crossing += (crossing.empty() ? "" : " ") + robot.links[a].name + "-" + robot.links[b].name;
  }
  return crossing;
}

}  // namespace prehend::test
