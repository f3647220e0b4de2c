// The hand's straight line, followed by the arm.
#include "sim/scene/reach/reach.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "tests/sim/scene/reach/arm_among_boxes.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

Pose hand_in_base(const CompiledArm& arm, const DofValues& dofs) {
  std::vector<Pose> X_BJ;
  joint_poses(arm.robot(), joint_values(arm.robot(), dofs), X_BJ);
  return X_BJ[index(arm.hand_part().joint)] * arm.hand_part().X_JR;
}

// 99 mm along the hand's approach axis, from where a random posture has it.
HandLine random_line(const CompiledScene& scene, Random& random) {
  const CompiledArm& arm = *scene.arm;
  HandLine line;
  line.X_OH_from = arm.X_BO.inverse() * hand_in_base(arm, test::random_dofs(arm.robot(), random));
  line.X_OH_to = line.X_OH_from * translation(0.099 * scene.scene.hand.hand->approach);
  line.hand_joints = joint_values(scene.scene.hand, scene.scene.hand.hand->preshapes[0].dofs);
  return line;
}

// The hand is on the line, in even steps, turned as at its beginning.
void expect_straight(const CompiledArm& arm, const HandLine& line,
                     const std::vector<DofValues>& on) {
  for (std::size_t i = 0; i < on.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(on.size() - 1);
    const Pose X_OH = arm.X_BO.inverse() * hand_in_base(arm, on[i]);
    const Vector3 expected = line.X_OH_from.translation() +
                             part * (line.X_OH_to.translation() - line.X_OH_from.translation());
    EXPECT_LT((X_OH.translation() - expected).norm(), 1e-8) << i;
    const Eigen::AngleAxisd turn(line.X_OH_from.linear().transpose() * X_OH.linear());
    EXPECT_LT(std::abs(turn.angle()), 1e-8) << i;
  }
}

void expect_continuous_inside_limits(const CompiledArm& arm, const std::vector<DofValues>& line,
                                     const ReachOptions& options) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    for (std::size_t d = 0; d < line[i].size(); ++d) {
      const DegreeOfFreedom& dof = arm.robot().dofs[d];
      EXPECT_GE(line[i][d], dof.lower) << dof.name;
      EXPECT_LE(line[i][d], dof.upper) << dof.name;
      if (i == 0) continue;
      EXPECT_LE(std::abs(line[i][d] - line[i - 1][d]), options.largest_joint_step) << dof.name;
    }
  }
}

// What does not carry the hand stays as it starts.
void expect_hand_at_rest(const CompiledArm& arm, const std::vector<DofValues>& line) {
  const auto first = index(arm.hand_part().first_dof);
  for (const DofValues& dofs : line) {
    for (std::size_t d = first; d < dofs.size(); ++d) EXPECT_EQ(dofs[d], arm.start[d]);
  }
}

// How many of `count` random lines are reached; each of them is looked at.
int reached_lines(const CompiledScene& scene, std::uint64_t seed, int count) {
  const CompiledArm& arm = *scene.arm;
  const ReachOptions options;
  Random random(seed);
  int reached = 0;
  for (int i = 0; i < count; ++i) {
    SCOPED_TRACE("line " + std::to_string(i));
    const HandLine line = random_line(scene, random);
    const Reach reach = find_reach(arm, line, options);
    EXPECT_EQ(reach.line.empty(), reach.end != ReachEnd::reached);
    EXPECT_EQ(reach.pair.has_value(), reach.end == ReachEnd::blocked);
    if (reach.end != ReachEnd::reached) continue;
    ++reached;
    EXPECT_EQ(reach.line.size(), 51U);  // 99 mm in steps of 2
    expect_straight(arm, line, reach.line);
    expect_continuous_inside_limits(arm, reach.line, options);
    expect_hand_at_rest(arm, reach.line);
    for (const DofValues& dofs : reach.line) {
      EXPECT_FALSE(first_meeting(arm, arm.arm_pairs, arm_joints(arm, dofs, line.hand_joints)));
    }
  }
  return reached;
}

TEST(Reach, AnArmFollowsTheLine) {
  EXPECT_GE(reached_lines(test::compiled_library_scene("mug_on_table"), 91, 60), 15);
}

TEST(Reach, AnArmOnABaseFollowsTheLine) {
  EXPECT_GE(reached_lines(test::compiled_library_scene("living_room"), 92, 12), 4);
}

TEST(Reach, ANearbyLineIsReachedWithTheShortestWayFirst) {
  const CompiledScene scene = test::compiled_library_scene("mug_on_table");
  const CompiledArm& arm = *scene.arm;
  Random random(93);
  const auto ways = postures_at(arm, random_line(scene, random).X_OH_from, {});
  ASSERT_GE(ways.size(), 2U);
  const auto way = [&](const DofValues& dofs) {
    double sum = 0.0;
    for (const int d : arm.dofs) sum += std::pow(dofs[index(d)] - arm.start[index(d)], 2);
    return sum;
  };
  for (const DofValues& dofs : ways) EXPECT_GE(way(dofs), way(ways.front()) - 1e-12);
}

// Each way of several that reach the same pose, found again from its last posture.
TEST(Reach, ALineFollowedBackIsTheOneThatEndsThere) {
  const CompiledScene scene = test::compiled_library_scene("mug_on_table");
  const CompiledArm& arm = *scene.arm;
  Random random(96);
  int lines = 0;
  for (int i = 0; i < 40; ++i) {
    const HandLine line = random_line(scene, random);
    for (const Reach& way : find_reaches(arm, line, 4, {})) {
      if (way.end != ReachEnd::reached) continue;
      const std::vector<DofValues> again = line_ending_in(arm, line, way.line.back(), {});
      ASSERT_EQ(again.size(), way.line.size());
      EXPECT_EQ(again.back(), way.line.back());
      for (std::size_t p = 0; p < again.size(); ++p) {
        for (const int d : arm.dofs) EXPECT_NEAR(again[p][index(d)], way.line[p][index(d)], 1e-5);
      }
      ++lines;
    }
  }
  EXPECT_GE(lines, 20);
}

TEST(Reach, WhatIsFarAwayIsUnreachable) {
  const CompiledScene scene = compile(test::arm_scene({}));
  Random random(94);
  for (int i = 0; i < 10; ++i) {
    HandLine line = random_line(scene, random);
    const Vector3 away = 5.0 * random.direction();
    line.X_OH_from.translation() += away;
    line.X_OH_to.translation() += away;
    const Reach reach = find_reach(*scene.arm, line, {});
    EXPECT_EQ(reach.end, ReachEnd::unreachable);
    EXPECT_FALSE(reach.pair.has_value());
    EXPECT_TRUE(postures_at(*scene.arm, line.X_OH_from, {}).empty());
  }
}

// The pre-grasp is reached, but nothing two metres behind it.
TEST(Reach, ALineThatLeavesTheReachIsNotReached) {
  const CompiledScene scene = compile(test::arm_scene({}));
  Random random(95);
  int unreachable = 0;
  for (int i = 0; i < 20; ++i) {
    HandLine line = random_line(scene, random);
    line.X_OH_to = line.X_OH_from * translation(Vector3(0.0, 0.0, 2.0));
    const Reach reach = find_reach(*scene.arm, line, {});
    EXPECT_NE(reach.end, ReachEnd::reached);  // blocked where the arm meets itself
    EXPECT_TRUE(reach.line.empty());
    unreachable += reach.end == ReachEnd::unreachable ? 1 : 0;
  }
  EXPECT_GE(unreachable, 5);
}

// A cube in the forearm of each posture of the pre-grasp.
StaticBody cubes_in_forearms(const CompiledArm& arm, const HandLine& line, double side) {
  StaticBody cubes;
  cubes.name = "cubes";
  for (const DofValues& dofs : postures_at(arm, line.X_OH_from, {})) {
    std::vector<Pose> X_BL;
    arm_link_poses(arm, arm_joints(arm, dofs, line.hand_joints), X_BL);
    for (std::size_t l = 0; l < X_BL.size(); ++l) {
      if (arm.links[l].name != "arm/forearm") continue;
      append(cubes.mesh,
             transformed(make_box(Vector3::Constant(side)),
                         X_BL[l] * translation(bounds(arm.links[l].mesh.mesh()).center())));
    }
  }
  return cubes;
}

// Cubes that cross the forearm, and such that are all inside it.
void expect_blocked_by_cubes(double side) {
  const CompiledScene empty = compile(test::arm_scene({}));
  Random random(96);
  int blocked = 0;
  for (int i = 0; i < 40; ++i) {
    const HandLine line = random_line(empty, random);
    if (find_reach(*empty.arm, line, {}).end != ReachEnd::reached) continue;
    try {
      const CompiledScene scene =
          compile(test::arm_scene({cubes_in_forearms(*empty.arm, line, side)}));
      const Reach reach = find_reach(*scene.arm, line, {});
      ASSERT_EQ(reach.end, ReachEnd::blocked) << i;
      ASSERT_TRUE(reach.pair.has_value());
      EXPECT_EQ(first_name(*scene.arm, *reach.pair).rfind("arm/", 0), 0U);
      EXPECT_EQ(second_name(*scene.arm, *reach.pair), "cubes");
      ++blocked;
    } catch (const InputError&) {
      continue;  // the start posture collides with the cubes
    }
  }
  EXPECT_GE(blocked, 10);
}

TEST(Reach, NamesTheLinkAndTheObstacleInItsWay) { expect_blocked_by_cubes(0.1); }
TEST(Reach, NamesAnObstacleThatTheLinkHolds) { expect_blocked_by_cubes(0.01); }

}  // namespace
}  // namespace prehend
