#include "planner/plan/path/lift_object.h"

#include <gtest/gtest.h>

#include "planner/plan/path/grasp_path.h"
#include "sim/base/index.h"
#include "sim/scene/carried_object.h"
#include "tests/support/block_on_table.h"

namespace prehend {
namespace {

std::vector<std::string> segments_of(const Trajectory& path) {
  std::vector<std::string> names;
  for (const TrajectorySegment& segment : path.segments) names.push_back(segment.name);
  return names;
}

// A bar across, beside the block at a height in its frame.
StaticBody bar_beside(const Pose& X_WO, double height) {
  StaticBody body;
  body.name = "bar";
  body.mesh = make_box({0.01, 0.3, 0.01});
  body.X_WB = X_WO * translation({0.045, 0.0, height});
  return body;
}

class Lift : public testing::Test {
 protected:
  static GraspPath path_in(const CompiledScene& scene, const GraspPathOptions& options = {}) {
    const test::Grasp grasp = test::stable_grasp(scene);
    const auto path = plan_grasp_path(scene, grasp.candidate, grasp.trial, options);
    EXPECT_TRUE(path.has_value());
    return path.value_or(GraspPath{});
  }

  static Pose hand_at(const CompiledScene& scene, const std::vector<double>& joints) {
    const CompiledArm& arm = *scene.arm;
    std::vector<Pose> X_BJ;
    joint_poses(arm.robot(), joints, X_BJ);
    return arm.X_WB * X_BJ[index(arm.hand_part().joint)] * arm.hand_part().X_JR;
  }
};

TEST_F(Lift, TheHandGoesStraightUpAndBackToTheStart) {
  const CompiledScene scene = compile(test::block_on_table());
  GraspPathOptions options;
  options.lift.height = 0.07;
  const GraspPath path = path_in(scene, options);
  EXPECT_EQ(path.lift, LiftEnd::complete);
  const auto names = segments_of(path.motion);
  ASSERT_GE(names.size(), 4U);
  EXPECT_EQ(names[names.size() - 2], "lift");
  EXPECT_EQ(names.back(), "retreat");
  const TrajectorySegment& lift = path.motion.segments[names.size() - 2];
  const Pose before = hand_at(scene, path.motion.positions[index(lift.first)]);
  const Pose after = hand_at(scene, path.motion.positions[index(lift.last)]);
  EXPECT_TRUE((after.translation() - before.translation()).isApprox(Vector3(0, 0, 0.07), 1e-6));
  EXPECT_TRUE(after.linear().isApprox(before.linear(), 1e-6));
  // The arm is at its start, the hand closed.
  const CompiledArm& arm = *scene.arm;
  const std::vector<double> start = joint_values(arm.robot(), arm.start);
  const std::vector<double>& closed = path.motion.positions[index(lift.first)];
  for (std::size_t j = 0; j < start.size(); ++j) {
    const bool of_hand = index(arm.hand_part().first_joint) <= j;
    EXPECT_NEAR(path.motion.positions.back()[j], of_hand ? closed[j] : start[j], 1e-9) << j;
  }
  EXPECT_TRUE(check_path(scene, path.motion).ok());
}

TEST_F(Lift, IsLeftOutWhereItIsNotAsked) {
  const CompiledScene scene = compile(test::block_on_table());
  GraspPathOptions options;
  options.lift.retreat = false;
  const GraspPath lifted = path_in(scene, options);
  EXPECT_EQ(lifted.lift, LiftEnd::complete);
  EXPECT_EQ(segments_of(lifted.motion).back(), "lift");
  options.lift.height = 0.0;
  const GraspPath bare = path_in(scene, options);
  EXPECT_EQ(bare.lift, LiftEnd::not_asked);
  EXPECT_EQ(segments_of(bare.motion).back(), "close");
}

TEST_F(Lift, OutOfReachIsSaid) {
  const CompiledScene scene = compile(test::block_on_table());
  GraspPathOptions options;
  options.lift.height = 2.0;
  const GraspPath path = path_in(scene, options);
  EXPECT_EQ(path.lift, LiftEnd::lift_unreachable);
  EXPECT_EQ(segments_of(path.motion).back(), "close");
}

// A bar above the foot of the block, which only the foot meets on its way up.
TEST_F(Lift, WhatTheObjectMeetsBlocksIt) {
  for (const bool has_foot : {true, false}) {
    Scene scene = test::block_on_table();
    TriangleMesh block = scene.object.mesh;
    TriangleMesh foot = make_box({has_foot ? 0.12 : 0.02, 0.02, 0.01});
    for (Vector3& p : foot.vertices) p.z() -= 0.054;
    const int offset = static_cast<int>(block.vertices.size());
    block.vertices.insert(block.vertices.end(), foot.vertices.begin(), foot.vertices.end());
    for (auto triangle : foot.triangles) {
      for (auto& corner : triangle) corner += offset;
      block.triangles.push_back(triangle);
    }
    const Pose X_WO = scene.object.X_WO;
    scene.object = make_graspable("block", block, Material::plastic);
    scene.object.X_WO = X_WO;
    scene.obstacles.push_back(bar_beside(X_WO, -0.035));
    const CompiledScene compiled = compile(std::move(scene));
    const GraspPath path = path_in(compiled);
    EXPECT_EQ(path.lift, has_foot ? LiftEnd::lift_blocked : LiftEnd::complete);
    EXPECT_EQ(segments_of(path.motion).back(), has_foot ? "close" : "retreat");
  }
}

TEST_F(Lift, ACarriedObjectMovesWithTheHand) {
  const CompiledScene scene = compile(test::block_on_table());
  const test::Grasp grasp = test::stable_grasp(scene);
  const CompiledArm arm = arm_with_object(scene, grasp.trial.X_OH);
  EXPECT_EQ(arm.links.size(), scene.arm->links.size() + 1);
  EXPECT_EQ(arm.links[index(carried_object(arm))].name, "block");
  // At the grasp it is where it stood, and moved on its vertices go along.
  const std::vector<double> joints = arm_joints(arm, grasp.trial.arm_dofs, grasp.trial.joints);
  std::vector<Pose> X_BL;
  arm_link_poses(arm, joints, X_BL);
  const TriangleMesh& mesh = arm.robot().links.back().mesh;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const Vector3 p_B = arm.X_BO * scene.scene.object.mesh.vertices[v];
    EXPECT_LT((X_BL.back() * mesh.vertices[v] - p_B).norm(), 1e-6);
  }
  // No pair of the object with the hand, or with itself where it stood.
  for (const auto* pairs : {&arm.arm_pairs, &arm.hand_pairs}) {
    for (const ArmPair& pair : *pairs) {
      const LinkId* link = std::get_if<LinkId>(&pair.other);
      if (link == nullptr) {
        EXPECT_FALSE(std::get<BodyId>(pair.other).is_object());
      } else if (pair.link == carried_object(arm)) {
        EXPECT_FALSE(arm.is_hand_link(*link));
      }
    }
  }
}

}  // namespace
}  // namespace prehend
