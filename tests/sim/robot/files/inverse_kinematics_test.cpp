#include "sim/robot/inverse_kinematics.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/robot/files/platform_file.h"
#include "sim/robot/files/robot_file.h"
#include "tests/support/trees.h"

namespace prehend {
namespace {

struct Miss {
  double position = 0.0;  // m
  double angle = 0.0;     // rad
};

Miss miss(const Robot& robot, const IkTarget& target, const DofValues& values) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, joint_values(robot, values), X_BJ);
  const Pose X_BT = X_BJ[static_cast<std::size_t>(target.joint)] * target.X_JT;
  const Eigen::AngleAxisd turn(target.X_BT.linear().transpose() * X_BT.linear());
  return {(X_BT.translation() - target.X_BT.translation()).norm(), std::abs(turn.angle())};
}

void expect_inside_limits(const Robot& robot, const DofValues& values) {
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    EXPECT_GE(values[d], robot.dofs[d].lower) << robot.dofs[d].name;
    EXPECT_LE(values[d], robot.dofs[d].upper) << robot.dofs[d].name;
  }
}

DofValues random_values(const Robot& robot, Random& random) {
  DofValues values;
  for (const DegreeOfFreedom& dof : robot.dofs) {
    // A base that can roll 100 m away is asked for no more than a room.
    const double upper = std::min(dof.upper, dof.lower + 10.0);
    values.push_back(random.uniform(dof.lower, upper));
  }
  return values;
}

IkTarget where_it_is(const Robot& robot, int joint, const Pose& X_JT, const DofValues& values) {
  std::vector<Pose> X_BJ;
  joint_poses(robot, joint_values(robot, values), X_BJ);
  return {joint, X_JT, X_BJ[static_cast<std::size_t>(joint)] * X_JT};
}

TEST(SphericalWrist, SolvesEveryReachablePoseOfThePuma) {
  const Robot puma = find_robot("puma560");
  ASSERT_EQ(puma.chains[0].closed_form, ClosedForm::spherical_wrist);
  Random random(11);
  std::array<int, 9> by_count{};
  for (int i = 0; i < 10000; ++i) {
    const DofValues asked = random_values(puma, random);
    const IkTarget target = where_it_is(puma, 5, Pose::Identity(), asked);
    const auto found = solve_all(puma, {target}, asked);
    ASSERT_FALSE(found.empty()) << i;
    ++by_count[found.size()];
    double nearest = 1.0;
    for (const DofValues& values : found) {
      const Miss missed = miss(puma, target, values);
      EXPECT_LE(missed.position, 1e-9);
      EXPECT_LE(missed.angle, 1e-9);
      expect_inside_limits(puma, values);
      double off = 0.0;
      for (std::size_t d = 0; d < 6; ++d) off = std::max(off, std::abs(values[d] - asked[d]));
      nearest = std::min(nearest, off);
    }
    EXPECT_LE(nearest, 1e-6) << "the posture asked is not among the solutions, pose " << i;
  }
  EXPECT_GT(by_count[4] + by_count[8], 0);
}

TEST(SphericalWrist, FindsAllEightBranchesWhereLimitsAllow) {
  Robot puma = find_robot("puma560");
  for (std::size_t j = 0; j < 6; ++j) {
    puma.joints[j].lower = puma.dofs[j].lower = -4.0;
    puma.joints[j].upper = puma.dofs[j].upper = 4.0;
  }
  const DofValues asked = {0.3, 0.6, -0.9, 0.5, 0.7, -0.4};
  const IkTarget target = where_it_is(puma, 5, Pose::Identity(), asked);
  const auto found = solve_all(puma, {target}, asked);
  ASSERT_EQ(found.size(), 8U);
  for (const DofValues& values : found) EXPECT_LE(miss(puma, target, values).position, 1e-9);
}

TEST(SphericalWrist, AStraightWristKeepsItsFirstJoint) {
  const Robot puma = find_robot("puma560");
  const DofValues asked = {0.3, 0.6, -0.9, 0.5, 0.0, -0.4};
  const IkTarget target = where_it_is(puma, 5, Pose::Identity(), asked);
  const auto found = solve_all(puma, {target}, asked);
  ASSERT_FALSE(found.empty());
  for (std::size_t d = 0; d < 6; ++d) EXPECT_NEAR(found[0][d], asked[d], 1e-7);
}

TEST(SphericalWrist, OutOfReachIsNoSolution) {
  const Robot puma = find_robot("puma560");
  IkTarget target{5, Pose::Identity(), translation({1.2, 0.0, 0.0})};
  EXPECT_TRUE(solve_all(puma, {target}, initial_dofs(puma)).empty());
  target.X_BT = translation({0.0, 0.05, 0.3});  // inside the cylinder that the offset keeps free
  EXPECT_TRUE(solve_all(puma, {target}, initial_dofs(puma)).empty());
}

// The numeric solver alone must do nearly as well on every arm and platform of the library.
void check_numeric(Robot robot, int joint, const Pose& X_JT) {
  for (Chain& chain : robot.chains) chain.closed_form = ClosedForm::none;
  Random random(21);
  const std::vector<int> dofs = dofs_to(robot, joint);
  int solved = 0;
  constexpr int kPoses = 1000;
  for (int i = 0; i < kPoses; ++i) {
    const IkTarget target = where_it_is(robot, joint, X_JT, random_values(robot, random));
    IkOptions options;
    options.max_solutions = 1;
    const auto found = solve_all(robot, {target}, initial_dofs(robot), options);
    if (found.empty()) continue;
    ++solved;
    const Miss missed = miss(robot, target, found[0]);
    EXPECT_LE(missed.position, 1e-9);
    EXPECT_LE(missed.angle, 1e-9);
    expect_inside_limits(robot, found[0]);
  }
  EXPECT_GE(solved, 995) << robot.name;
  testing::Test::RecordProperty(robot.name, solved);
}

TEST(InverseKinematics, SolvesNearlyAllReachablePosesOfEveryArm) {
  check_numeric(find_robot("puma560"), 5, Pose::Identity());
  check_numeric(find_robot("xr4000"), 2, Pose::Identity());
  for (const std::string& name : library_platform_names()) {
    const Platform platform = find_platform(name);
    const AssembledPlatform whole = assemble(platform);
    const PlatformPart& hand = whole.parts[static_cast<std::size_t>(hand_of(platform))];
    check_numeric(whole.robot, hand.joint, hand.X_JR);
  }
}

TEST(InverseKinematics, RedundantRobotsStayAwayFromLimits) {
  const Platform platform = find_platform("obelix");
  const AssembledPlatform whole = assemble(platform);
  const PlatformPart& hand = whole.parts.back();
  const std::vector<int> dofs = dofs_to(whole.robot, hand.joint);
  DofValues start = initial_dofs(whole.robot);
  start[0] = start[1] = 3.0;
  Random random(5);
  int roomy = 0;
  for (int i = 0; i < 50; ++i) {
    DofValues asked = random_values(whole.robot, random);
    asked[0] = random.uniform(2.0, 4.0);
    asked[1] = random.uniform(2.0, 4.0);
    const IkTarget target = where_it_is(whole.robot, hand.joint, hand.X_JR, asked);
    const auto found = solve_all(whole.robot, {target}, start);
    ASSERT_GE(found.size(), 2U);
    double margin = 0.0;
    for (const DofValues& values : found) {
      EXPECT_LE(miss(whole.robot, target, values).position, 1e-8);
      margin = std::max(margin, limit_margin(whole.robot, {3, 4, 5, 6, 7, 8}, values));
    }
    roomy += margin > 0.1;
  }
  EXPECT_GE(roomy, 45);
}

// Two fingertips at once: a tree of chains.
TEST(InverseKinematics, SolvesATreeOfChains) {
  const Robot hand = find_robot("barrett");
  Random random(8);
  int solved = 0;
  for (int i = 0; i < 50; ++i) {
    DofValues asked = random_values(hand, random);
    const std::vector<IkTarget> targets = {where_it_is(hand, 2, Pose::Identity(), asked),
                                           where_it_is(hand, 5, Pose::Identity(), asked)};
    const auto found = solve_all(hand, targets, initial_dofs(hand));
    if (found.empty()) continue;
    ++solved;
    for (const IkTarget& target : targets) EXPECT_LE(miss(hand, target, found[0]).position, 1e-8);
    for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(found[0][d], asked[d], 1e-6);
    EXPECT_EQ(found[0][3], hand.dofs[3].initial);  // the thumb moves neither
  }
  EXPECT_EQ(solved, 50);
}

// Targets on two branches of one finger, which share the joint before them.
TEST(InverseKinematics, SolvesABranchingFinger) {
  const Robot hand = test::branching_hand();
  Random random(9);
  for (int i = 0; i < 30; ++i) {
    const DofValues asked = random_values(hand, random);
    const std::vector<IkTarget> targets = {where_it_is(hand, 3, random.pose(0.01), asked),
                                           where_it_is(hand, 2, Pose::Identity(), asked)};
    const auto found = solve_all(hand, targets, initial_dofs(hand));
    ASSERT_FALSE(found.empty()) << i;
    for (const IkTarget& target : targets) EXPECT_LE(miss(hand, target, found[0]).position, 1e-8);
    for (std::size_t d = 0; d < 4; ++d) EXPECT_NEAR(found[0][d], asked[d], 1e-6);
    EXPECT_EQ(found[0][4], hand.dofs[4].initial);  // the other nail moves neither
  }
}

TEST(InverseKinematics, SolvesRandomTreesOfAnyAxes) {
  Random random(10);
  int solved = 0;
  for (int i = 0; i < 40; ++i) {
    const Robot robot = test::random_tree(random, 7);
    const DofValues asked = random_values(robot, random);
    const std::vector<IkTarget> targets = {where_it_is(robot, 6, random.pose(0.1), asked),
                                           where_it_is(robot, 5, random.pose(0.1), asked)};
    const auto found = solve_all(robot, targets, asked);
    solved += !found.empty();
    // From close by, as a motion would ask.
    DofValues near = asked;
    for (std::size_t d = 0; d < near.size(); ++d) {
      near[d] = std::clamp(near[d] + random.uniform(-1e-3, 1e-3), robot.dofs[d].lower,
                           robot.dofs[d].upper);
    }
    const auto again = solve_near(robot, targets, near);
    ASSERT_TRUE(again.has_value()) << i;
    for (const IkTarget& target : targets) {
      EXPECT_LE(miss(robot, target, *again).position, 1e-8);
      EXPECT_LE(miss(robot, target, *again).angle, 1e-8);
    }
    expect_inside_limits(robot, *again);
  }
  EXPECT_EQ(solved, 40);
}

TEST(InverseKinematics, SameSeedSameSolutions) {
  const Platform platform = find_platform("obelix");
  const AssembledPlatform whole = assemble(platform);
  const PlatformPart& hand = whole.parts.back();
  DofValues start = initial_dofs(whole.robot);
  const IkTarget target = where_it_is(whole.robot, hand.joint, hand.X_JR, start);
  EXPECT_EQ(solve_all(whole.robot, {target}, start), solve_all(whole.robot, {target}, start));
}

}  // namespace
}  // namespace prehend
