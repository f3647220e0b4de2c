#include "sim/robot/move_robot.h"

#include <gtest/gtest.h>

#include "sim/robot/files/platform_file.h"

namespace prehend {
namespace {

Pose base_of(const AssembledPlatform& platform, int part, const DofValues& dofs) {
  std::vector<Pose> X_BJ;
  joint_poses(platform.robot, joint_values(platform.robot, dofs), X_BJ);
  const PlatformPart& moved = platform.parts[static_cast<std::size_t>(part)];
  return X_BJ[static_cast<std::size_t>(moved.joint)] * moved.X_JR;
}

// Obelix: base, arm, hand.
TEST(MoveRobot, AnArmIsMovedByTheBaseBelowIt) {
  const AssembledPlatform obelix = assemble(find_platform("obelix"));
  const DofValues now = initial_dofs(obelix.robot);
  const Pose X_BA = base_of(obelix, 1, now);
  const Pose X_BH = base_of(obelix, 2, now);
  const Pose move = translation({1.5, 0.7, 0.0}) * Eigen::AngleAxisd(0.4, Vector3::UnitZ());
  const auto moved = move_robot(obelix, 1, move * X_BA, now);
  ASSERT_TRUE(moved.has_value());
  EXPECT_TRUE(base_of(obelix, 1, *moved).isApprox(move * X_BA, 1e-8));
  EXPECT_TRUE(base_of(obelix, 2, *moved).isApprox(move * X_BH, 1e-8));  // the hand goes along
  for (std::size_t d = 3; d < now.size(); ++d) EXPECT_EQ((*moved)[d], now[d]);
}

TEST(MoveRobot, TheBaseDoesNotLiftTheArm) {
  const AssembledPlatform obelix = assemble(find_platform("obelix"));
  const DofValues now = initial_dofs(obelix.robot);
  EXPECT_FALSE(move_robot(obelix, 1, translation({0.0, 0.0, 0.1}) * base_of(obelix, 1, now), now));
}

TEST(MoveRobot, AHandIsMovedByAllBelowIt) {
  const AssembledPlatform obelix = assemble(find_platform("obelix"));
  const DofValues now = initial_dofs(obelix.robot);
  const Pose X_BH = translation({3.0, 2.0, -0.1}) * base_of(obelix, 2, now);
  const auto moved = move_robot(obelix, 2, X_BH, now);
  ASSERT_TRUE(moved.has_value());
  EXPECT_TRUE(base_of(obelix, 2, *moved).isApprox(X_BH, 1e-8));
}

TEST(MoveRobot, WhatStandsOnNothingStays) {
  const AssembledPlatform obelix = assemble(find_platform("obelix"));
  EXPECT_FALSE(move_robot(obelix, 0, Pose::Identity(), initial_dofs(obelix.robot)));
}

}  // namespace
}  // namespace prehend
