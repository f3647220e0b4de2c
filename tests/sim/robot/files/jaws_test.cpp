// The parallel grippers: where their pads are, and how far they open.
#include <cmath>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/hand_shape.h"

namespace prehend {
namespace {

constexpr double kJawRounding = 1e-12;

// Bounds of all rubber links on the side of the sign of x, in the base frame.
Bounds rubber_bounds(const Robot& robot, const std::vector<double>& dofs, double side) {
  const std::vector<Pose> X_BL = test::poses_at(robot, dofs);
  Bounds all;
  for (std::size_t l = 0; l < robot.links.size(); ++l) {
    if (robot.links[l].material != "rubber") continue;
    const Bounds box = bounds(transformed(robot.links[l].mesh, X_BL[l]));
    if (box.center().x() * side < 0.0) continue;
    all.lower = all.lower.cwiseMin(box.lower);
    all.upper = all.upper.cwiseMax(box.upper);
  }
  return all;
}

double gap(const Robot& robot, const std::vector<double>& dofs) {
  return rubber_bounds(robot, dofs, 1.0).lower.x() - rubber_bounds(robot, dofs, -1.0).upper.x();
}

TEST(FrankaHand, HasTheFrameOfPublishedGrasps) {
  const Robot robot = find_robot("franka_hand");
  EXPECT_EQ(robot.hand->approach, Vector3::UnitZ());
  EXPECT_EQ(robot.hand->closing, Vector3::UnitX());
  const std::vector<double> open = {0.04};
  EXPECT_NEAR(gap(robot, open), 0.08, kJawRounding);
  for (const double side : {-1.0, 1.0}) {
    const Bounds pad = rubber_bounds(robot, open, side);
    EXPECT_NEAR(pad.upper.z(), 0.112, kJawRounding);
    EXPECT_NEAR(pad.lower.y() + pad.upper.y(), 0.0, kJawRounding);
  }
}

TEST(FrankaHand, FingersMirrorEachOther) {
  const Robot robot = find_robot("franka_hand");
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_EQ(robot.dofs[0].coupling, Coupling::self_centering);
  EXPECT_LT(robot.dofs[0].closing_velocity, 0.0);
  for (const double opening : {0.001, 0.013, 0.04}) {
    EXPECT_NEAR(gap(robot, {opening}), 2.0 * opening, kJawRounding);
    EXPECT_NEAR(rubber_bounds(robot, {opening}, 1.0).lower.x(), opening, kJawRounding);
  }
}

TEST(FrankaHand, PadsLeadTheMetalBehindThem) {
  const Robot robot = find_robot("franka_hand");
  const std::vector<Pose> X_BL = test::poses_at(robot, {0.04});
  for (std::size_t l = 1; l < robot.links.size(); ++l) {
    if (robot.links[l].material != "metal") continue;
    const Bounds box = bounds(transformed(robot.links[l].mesh, X_BL[l]));
    EXPECT_GE(std::min(std::abs(box.lower.x()), std::abs(box.upper.x())), 0.042 - kJawRounding);
  }
}

// The hand's reach along the approach and across the fingers: the published gripper's, to 1 mm.
TEST(FrankaHand, BodyHasThePublishedExtents) {
  const Bounds body = bounds(find_robot("franka_hand").links[0].mesh);
  EXPECT_LT((body.lower - Vector3(-0.1004, -0.0316, -0.0259)).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_LT((body.upper - Vector3(0.1040, 0.0316, 0.0660)).cwiseAbs().maxCoeff(), 1e-3);
}

struct JawCase {
  const char* name;
  double opening;  // of both plates together [m]
};

class ParallelJaw : public testing::TestWithParam<JawCase> {};

TEST_P(ParallelJaw, PlatesMoveIndependently) {
  const Robot robot = find_robot(GetParam().name);
  ASSERT_EQ(robot.dofs.size(), 2U);
  const double half = 0.5 * GetParam().opening;
  EXPECT_NEAR(robot.dofs[0].upper, half, kJawRounding);
  EXPECT_NEAR(gap(robot, {half, half}), GetParam().opening, kJawRounding);
  EXPECT_NEAR(rubber_bounds(robot, {0.01, 0.03}, 1.0).lower.x(), 0.01, kJawRounding);
  EXPECT_NEAR(rubber_bounds(robot, {0.01, 0.03}, -1.0).upper.x(), -0.03, kJawRounding);
}

TEST_P(ParallelJaw, PlatesReachPastTheMiddleOfWhatFitsBetweenThem) {
  const Robot robot = find_robot(GetParam().name);
  const Preshape& open = robot.hand->preshapes[0];
  EXPECT_NEAR(open.max_width, GetParam().opening, kJawRounding);
  const Bounds plate = rubber_bounds(robot, open.dofs, 1.0);
  EXPECT_GT(plate.upper.z() - robot.hand->origin.z(), 0.5 * GetParam().opening);
  EXPECT_LT(open.depth, plate.upper.z());
}

INSTANTIATE_TEST_SUITE_P(Sizes, ParallelJaw,
                         testing::Values(JawCase{"parallel_jaw", 0.08},
                                         JawCase{"parallel_jaw_wide", 0.14}),
                         [](const auto& one) { return std::string(one.param.name); });

TEST(ParallelJaws, WideVersionDiffersInLimitsAndPalmOnly) {
  const Robot small = find_robot("parallel_jaw");
  const Robot wide = find_robot("parallel_jaw_wide");
  ASSERT_EQ(small.links.size(), wide.links.size());
  for (std::size_t l = 1; l < small.links.size(); ++l) {
    EXPECT_EQ(small.links[l].mesh.vertices, wide.links[l].mesh.vertices);
    EXPECT_EQ(small.links[l].mesh.triangles, wide.links[l].mesh.triangles);
  }
  EXPECT_GT(wide.dofs[0].upper, 0.5 * 0.104) << "the widest part of a coffee mug";
}

}  // namespace
}  // namespace prehend
