// A robot against what another simulator printed of it: lengths in millimetres.
#pragma once

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/robot/robot.h"
#include "tests/sim/robot/files/hand_shape.h"
#include "tests/support/shared_data.h"

namespace prehend::test {

inline nlohmann::json reference(const std::string& file) {
  return nlohmann::json::parse(std::ifstream(shared(file)));
}

inline Pose pose_of(const nlohmann::json& json) {
  const auto q = json["quat_wxyz"].get<std::vector<double>>();
  const auto t = json["t_mm"].get<std::vector<double>>();
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
  pose.translation() = 1e-3 * Vector3(t[0], t[1], t[2]);
  return pose;
}

// Index in robot.links of link `k` of chain `c`, when every joint has one.
inline std::size_t link_index(const Robot& robot, int c, int k) {
  const Chain& chain = robot.chains[static_cast<std::size_t>(c)];
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (robot.links[l].joint == chain.first_joint + k) return l;
  }
  ADD_FAILURE() << "no link " << k << " in chain " << c;
  return 0;
}

inline void expect_same_pose(const Pose& X, const Pose& expected, double tolerance) {
  EXPECT_LT((X.translation() - expected.translation()).norm(), tolerance);
  const Eigen::AngleAxisd turn(X.linear().transpose() * expected.linear());
  EXPECT_LT(std::abs(turn.angle()), tolerance);
}

// Metres or radians a unit of the reference, by degree of freedom.
inline std::vector<double> reference_units(const Robot& robot) {
  std::vector<double> units(robot.dofs.size(), 1.0);
  for (const Joint& joint : robot.joints) {
    if (joint.type == JointType::prismatic) units[static_cast<std::size_t>(joint.dof)] = 1e-3;
  }
  return units;
}

inline std::vector<double> reference_dofs(const Robot& robot, const nlohmann::json& pose) {
  auto dofs = pose["dof"].get<std::vector<double>>();
  const std::vector<double> units = reference_units(robot);
  for (std::size_t d = 0; d < dofs.size(); ++d) dofs[d] *= units[d];
  return dofs;
}

// For robots with a link behind every joint.
inline void expect_link_poses_agree(const Robot& robot, const nlohmann::json& json) {
  ASSERT_EQ(json["poses"].size(), 5U);
  for (const nlohmann::json& pose : json["poses"]) {
    const std::vector<Pose> X_BL = poses_at(robot, reference_dofs(robot, pose));
    for (const nlohmann::json& link : pose["links"]) {
      const std::size_t l = link_index(robot, link["chain"].get<int>(), link["link"].get<int>());
      SCOPED_TRACE(robot.links[l].name);
      expect_same_pose(X_BL[l], pose_of(link["pose"]), 1e-6);
    }
  }
}

inline void expect_limits_agree(const Robot& robot, const nlohmann::json& json) {
  ASSERT_EQ(json["dofs"].size(), robot.dofs.size());
  const std::vector<double> units = reference_units(robot);
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    EXPECT_NEAR(robot.dofs[d].lower, units[d] * json["dofs"][d]["min"].get<double>(), 1e-8);
    EXPECT_NEAR(robot.dofs[d].upper, units[d] * json["dofs"][d]["max"].get<double>(), 1e-8);
  }
}

}  // namespace prehend::test
