// Motions of an arm without a grasp: each way in which one can end.
#include "planner/plan/path/arm_path.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// The Panda, alone or beside a post that stands in the way of its first joint.
CompiledScene panda(bool with_post) {
  Scene scene;
  scene.name = "panda";
  scene.object = nothing_to_grasp();
  mount(scene, "panda");
  if (with_post) {
    add_obstacle(scene, "post", make_box({0.05, 0.05, 0.9}), translation({0.22, 0.22, 0.45}));
  }
  return compile(scene);
}

DofValues turned(const CompiledScene& scene, double angle) {
  DofValues values = scene.arm->start;
  values[0] = angle;
  return values;
}

TEST(ArmPath, IsAStraightLineWhereNothingStandsInTheWay) {
  const CompiledScene scene = panda(false);
  const DofValues goal = turned(scene, 1.5);
  const ArmPath path = plan_arm_path(scene, {goal});
  ASSERT_EQ(path.end, ArmPathEnd::found);
  EXPECT_EQ(path.waypoints, (std::vector<DofValues>{scene.arm->start, goal}));
  EXPECT_EQ(relative_length(path.waypoints), 1.0);
  EXPECT_TRUE(path.check.ok());
  ASSERT_EQ(path.motion.segments.size(), 1U);
  EXPECT_EQ(path.motion.positions.back()[0], 1.5);
  EXPECT_EQ(path.motion.velocities.back()[0], 0.0);
}

TEST(ArmPath, GoesAroundWhatStandsInTheWay) {
  const CompiledScene scene = panda(true);
  const ArmPath path = plan_arm_path(scene, {turned(scene, 1.5)});
  ASSERT_EQ(path.end, ArmPathEnd::found);
  EXPECT_GT(path.waypoints.size(), 2U);
  EXPECT_GT(relative_length(path.waypoints), 1.0);
  EXPECT_TRUE(path.check.ok());
}

TEST(ArmPath, SaysWhyThereIsNone) {
  const CompiledScene scene = panda(true);
  EXPECT_EQ(plan_arm_path(scene, {}).end, ArmPathEnd::unreachable);
  const ArmPath beyond = plan_arm_path(scene, {turned(scene, 4.0)});
  EXPECT_EQ(beyond.end, ArmPathEnd::beyond_limits);
  EXPECT_NE(beyond.why.find("arm/joint1 at 4"), std::string::npos) << beyond.why;
  // The hand of the arm is on the circle about its first joint that goes through the post.
  const ArmPath collides = plan_arm_path(scene, {turned(scene, 0.7853981633974483)});
  EXPECT_EQ(collides.end, ArmPathEnd::goal_collides);
  EXPECT_NE(collides.why.find("meets post"), std::string::npos) << collides.why;
  GraspPathOptions few;
  few.transfer.max_iterations = 1;
  const ArmPath missing = plan_arm_path(scene, {turned(scene, 1.5)}, few);
  EXPECT_EQ(missing.end, ArmPathEnd::not_found);
  EXPECT_EQ(missing.why.find("mostly "), 0U) << missing.why;
  EXPECT_NE(missing.why.find(" meets post"), std::string::npos) << missing.why;
}

TEST(ArmPath, TakesTheFirstGoalThatHasOneElseTheFailureThatCameFarthest) {
  const CompiledScene scene = panda(true);
  const DofValues beyond = turned(scene, 4.0);
  const DofValues collides = turned(scene, 0.7853981633974483);
  const DofValues free = turned(scene, -0.5);
  const ArmPath path = plan_arm_path(scene, {collides, beyond, free});
  ASSERT_EQ(path.end, ArmPathEnd::found);
  EXPECT_EQ(path.waypoints.back(), free);
  EXPECT_EQ(plan_arm_path(scene, {collides, beyond}).end, ArmPathEnd::goal_collides);
}

Pose hand_at(const CompiledArm& arm, const std::vector<double>& joints) {
  std::vector<Pose> X_BJ;
  joint_poses(arm.robot(), joints, X_BJ);
  return arm.X_WB * X_BJ[index(arm.hand_part().joint)] * arm.hand_part().X_JR;
}

// The middle of the time between two samples, on the cubic.
std::vector<double> half_way(const Trajectory& path, std::size_t i) {
  const double h = path.times[i + 1] - path.times[i];
  std::vector<double> joints;
  for (std::size_t j = 0; j < path.joints.size(); ++j) {
    joints.push_back(0.5 * (path.positions[i][j] + path.positions[i + 1][j]) +
                     0.125 * h * (path.velocities[i][j] - path.velocities[i + 1][j]));
  }
  return joints;
}

// The part of the way is the same in place and turn, and nothing is beside the way.
TEST(ArmLine, TakesTheHandAlongAStraightLineAtAConstantTurn) {
  const CompiledScene scene = panda(false);
  const CompiledArm& arm = *scene.arm;
  const Pose X_WH = hand_at(arm, joint_values(arm.robot(), arm.start));
  const Pose X_WG = X_WH * translation({0.05, -0.1, 0.15}) *
                    Pose(Eigen::AngleAxisd(0.6, Vector3(1.0, 2.0, -1.0).normalized()));
  const ArmPath path = plan_arm_line(scene, X_WG);
  ASSERT_EQ(path.end, ArmPathEnd::found) << path.why;
  EXPECT_TRUE(path.check.ok());
  ASSERT_EQ(path.motion.segments.size(), 1U);
  EXPECT_EQ(path.motion.segments[0].name, "line");
  const Vector3 way = X_WG.translation() - X_WH.translation();
  const Eigen::Quaterniond from(X_WH.linear());
  const Eigen::Quaterniond to(X_WG.linear());
  const auto expect_on_line = [&](const std::vector<double>& joints) {
    const Pose X = hand_at(arm, joints);
    const double part = (X.translation() - X_WH.translation()).dot(way) / way.squaredNorm();
    EXPECT_LT((X.translation() - X_WH.translation() - part * way).norm(), 1e-4);
    EXPECT_LT(
        from.slerp(std::clamp(part, 0.0, 1.0), to).angularDistance(Eigen::Quaterniond(X.linear())),
        1e-3);
  };
  for (std::size_t i = 0; i + 1 < path.motion.times.size(); ++i) {
    expect_on_line(path.motion.positions[i]);
    expect_on_line(half_way(path.motion, i));
  }
  const Pose X_end = hand_at(arm, path.motion.positions.back());
  EXPECT_LT((X_end.translation() - X_WG.translation()).norm(), 1e-7);
  EXPECT_LT((X_end.linear() - X_WG.linear()).norm(), 1e-7);
}

TEST(ArmLine, StaysWhereItIs) {
  const CompiledScene scene = panda(false);
  const CompiledArm& arm = *scene.arm;
  const ArmPath path = plan_arm_line(scene, hand_at(arm, joint_values(arm.robot(), arm.start)));
  ASSERT_EQ(path.end, ArmPathEnd::found) << path.why;
  EXPECT_TRUE(path.check.ok());
}

TEST(ArmLine, SaysWhyThereIsNone) {
  const CompiledScene scene = panda(true);
  const CompiledArm& arm = *scene.arm;
  const Pose X_WH = hand_at(arm, joint_values(arm.robot(), arm.start));
  const ArmPath far = plan_arm_line(scene, translation({2.0, 0.0, 0.0}) * X_WH);
  EXPECT_EQ(far.end, ArmPathEnd::unreachable);
  EXPECT_EQ(far.why.find("after "), 0U) << far.why;
  // Sideways into the post.
  const Vector3 post(0.22, 0.22, X_WH.translation().z());
  const ArmPath blocked =
      plan_arm_line(scene, translation(0.9 * (post - X_WH.translation())) * X_WH);
  EXPECT_EQ(blocked.end, ArmPathEnd::line_blocked);
  EXPECT_NE(blocked.why.find(" meets post"), std::string::npos) << blocked.why;
}

}  // namespace
}  // namespace prehend
