// Motions of an arm without a grasp: each way in which one can end.
#include "planner/plan/path/arm_path.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace prehend
