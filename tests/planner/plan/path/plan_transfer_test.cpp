#include "planner/plan/path/plan_transfer.h"

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/reach/motion_check.h"
#include "tests/support/block_on_table.h"

namespace prehend {
namespace {

const CompiledArm& arm_by_the_table() {
  static const CompiledScene kScene = compile(test::block_on_table());
  return *kScene.arm;
}

Transfer transfer_to(const CompiledArm& arm, const DofValues& to) {
  const std::vector<double> joints = joint_values(arm.robot(), arm.start);
  return {arm.start, to, {joints.begin() + arm.hand_part().first_joint, joints.end()}};
}

// A posture in which the arm meets something, found by lowering its shoulder.
DofValues in_the_table(const CompiledArm& arm) {
  DofValues dofs = arm.start;
  const auto shoulder = index(arm.dofs[1]);
  const DegreeOfFreedom& limits = arm.robot().dofs[shoulder];
  for (int k = 0; k <= 100; ++k) {
    dofs[shoulder] = limits.lower + 0.01 * k * (limits.upper - limits.lower);
    const Transfer transfer = transfer_to(arm, dofs);
    if (first_meeting(arm, arm.hand_pairs, arm_joints(arm, dofs, transfer.hand_joints))) break;
  }
  return dofs;
}

TEST(PlanTransfer, AnImpossibleEndHasNoWay) {
  const CompiledArm& arm = arm_by_the_table();
  const DofValues blocked = in_the_table(arm);
  const Transfer into = transfer_to(arm, blocked);
  ASSERT_TRUE(first_meeting(arm, arm.hand_pairs, arm_joints(arm, blocked, into.hand_joints)));
  EXPECT_TRUE(plan_transfer(arm, into).waypoints.empty());
  EXPECT_TRUE(plan_transfer(arm, {blocked, arm.start, into.hand_joints}).waypoints.empty());
  for (const int dof : arm.dofs) {
    DofValues beyond = arm.start;
    beyond[index(dof)] = arm.robot().dofs[index(dof)].upper + 1e-3;
    EXPECT_TRUE(plan_transfer(arm, transfer_to(arm, beyond)).waypoints.empty()) << dof;
  }
}

TEST(PlanTransfer, WaysEndWhereTheyShallAndEveryLineIsFree) {
  const CompiledArm& arm = arm_by_the_table();
  std::vector<ArmPair> pairs = arm.arm_pairs;
  pairs.insert(pairs.end(), arm.hand_pairs.begin(), arm.hand_pairs.end());
  // Turned away from the table, to where the arm is free.
  Transfer transfer = transfer_to(arm, arm.start);
  for (int k = 10; k >= 2; --k) {
    const DegreeOfFreedom& waist = arm.robot().dofs[index(arm.dofs[0])];
    transfer.to[index(arm.dofs[0])] = waist.lower + 0.05 * k * (waist.upper - waist.lower);
    if (!first_meeting(arm, pairs, arm_joints(arm, transfer.to, transfer.hand_joints))) break;
  }
  const std::vector<DofValues> way = plan_transfer(arm, transfer).waypoints;
  ASSERT_GE(way.size(), 2U);
  EXPECT_EQ(way.front(), transfer.from);
  EXPECT_EQ(way.back(), transfer.to);
  JointPath path;
  for (const DofValues& dofs : way) path.push_back(arm_joints(arm, dofs, transfer.hand_joints));
  EXPECT_FALSE(first_blocked(arm, pairs, path));
}

}  // namespace
}  // namespace prehend
