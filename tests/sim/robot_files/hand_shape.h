// Measures of a hand at given degrees of freedom, from its joints and meshes alone.
#pragma once

#include <string>
#include <vector>

#include "sim/geometry/proximity.h"
#include "sim/robot/robot.h"

namespace prehend::test {

inline std::vector<Pose> poses_at(const Robot& robot, const std::vector<double>& dofs) {
  std::vector<Pose> X_BL;
  link_poses(robot, joint_values(robot, dofs), X_BL);
  return X_BL;
}

// Links that share a joint or meet at one overlap by design.
inline bool adjacent(const Robot& robot, const Link& a, const Link& b) {
  const auto parent = [&](const Link& link) {
    return link.joint < 0 ? -2 : robot.joints[static_cast<std::size_t>(link.joint)].parent;
  };
  return a.joint == b.joint || parent(a) == b.joint || parent(b) == a.joint;
}

// Names of links that are not adjacent and cross: "a-b c-d", "" when there are none.
inline std::string self_collisions(const Robot& robot, const std::vector<double>& dofs) {
  const std::vector<Pose> X_BL = poses_at(robot, dofs);
  std::vector<ProximityMesh> meshes;
  for (const Link& link : robot.links) meshes.emplace_back(link.mesh);
  std::string crossing;
  for (std::size_t a = 0; a < robot.links.size(); ++a) {
    for (std::size_t b = a + 1; b < robot.links.size(); ++b) {
      if (adjacent(robot, robot.links[a], robot.links[b])) continue;
      if (!surfaces_cross(meshes[a], meshes[b], X_BL[a].inverse() * X_BL[b])) continue;
      crossing += (crossing.empty() ? "" : " ") + robot.links[a].name + "-" + robot.links[b].name;
    }
  }
  return crossing;
}

}  // namespace prehend::test
