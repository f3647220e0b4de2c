// Where the approach ends, and that nothing is passed through on the way.
#include "sim/trial/approach.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

using test::block;
using test::compiled;

std::vector<double> open_joints(const Robot& hand) {
  return joint_values(hand, hand.hand->preshapes.front().dofs);
}

// The hand comes down along -z from `start` to `end` above the origin [m].
ApproachMotion from_above(const Robot& hand, double start, double end) {
  const Matrix3 turned = Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitX()).toRotationMatrix();
  ApproachMotion motion;
  motion.X_OH_end = pose_from(turned, Vector3(0.0, 0.0, end) - turned * hand.hand->origin);
  motion.approach_O = -Vector3::UnitZ();
  motion.distance = start - end;
  return motion;
}

ApproachResult approach_open(const CompiledScene& scene, const ApproachMotion& motion) {
  return approach(scene, open_joints(scene.scene.hand), motion, test::kDefaultTrial);
}

double least(const std::vector<double>& values) {
  return *std::min_element(values.begin(), values.end());
}

TEST(Approach, EndsWithinTheContactGapOfABox) {
  for (const char* name : {"franka_hand", "parallel_jaw_wide", "barrett"}) {
    const Robot hand = find_robot(name);
    // Wider than the palm and flat, so that fingers or palm come down on it.
    const CompiledScene scene = compiled(hand, make_box({0.3, 0.3, 0.02}));
    for (const double start : {0.2, 0.25, 0.31}) {
      const ApproachMotion motion = from_above(hand, start, -0.05);
      const ApproachResult result = approach_open(scene, motion);
      ASSERT_EQ(result.end, ApproachEnd::touched_object) << name;
      ASSERT_TRUE(result.touch.has_value());
      EXPECT_TRUE(result.touch->body.is_object());
      const auto gaps = test::object_gaps(scene, motion.at(result.travel), open_joints(hand));
      EXPECT_GT(least(gaps), 0.0);
      EXPECT_LE(least(gaps), test::kDefaultTrial.closed_gap() + 1e-12);
      EXPECT_NEAR(gaps[index(result.touch->link)], least(gaps), 1e-12) << name;
    }
  }
}

TEST(Approach, ReachesItsEndWhenNothingIsInTheWay) {
  const Robot hand = find_robot("franka_hand");
  const CompiledScene scene = compiled(hand, make_box({0.04, 0.03, 0.05}));
  const ApproachMotion motion = from_above(hand, 0.3, 0.04);
  const ApproachResult result = approach_open(scene, motion);
  EXPECT_EQ(result.end, ApproachEnd::stand_off);
  EXPECT_EQ(result.travel, motion.distance);
  EXPECT_FALSE(result.touch.has_value());
  EXPECT_TRUE(motion.at(result.travel).isApprox(motion.X_OH_end, 1e-15));
}

TEST(Approach, OfNoLengthLooksWhereItIs) {
  const Robot hand = find_robot("franka_hand");
  const CompiledScene scene = compiled(hand, make_box({0.04, 0.03, 0.05}));
  const auto ends_at = [&](double height) {
    return approach_open(scene, from_above(hand, height, height)).end;
  };
  EXPECT_EQ(ends_at(0.2), ApproachEnd::stand_off);
  EXPECT_EQ(ends_at(0.025 + 4e-5), ApproachEnd::touched_object);
  EXPECT_EQ(ends_at(0.0), ApproachEnd::starts_in_collision);
}

TEST(Approach, StopsAtAnObstacle) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const TriangleMesh object = make_box({0.04, 0.04, 0.04});
  const CompiledScene scene =
      compiled(hand, object,
               {test::obstacle(make_box({0.1, 0.1, 0.1}), {0.5, 0.0, 0.0}),
                test::obstacle(make_box({0.02, 0.02, 0.0001}), {0.07, 0.0, 0.1})});
  const ApproachMotion motion = from_above(hand, 0.4, 0.0);
  const ApproachResult result = approach_open(scene, motion);
  ASSERT_EQ(result.end, ApproachEnd::touched_obstacle);
  ASSERT_TRUE(result.touch.has_value());
  EXPECT_EQ(result.touch->body, BodyId::obstacle(1));
  const auto links = test::link_soups(scene, motion.at(result.travel), open_joints(hand));
  const double gap =
      test::surface_gap(links[index(result.touch->link)],
                        test::soup(scene.obstacles()[1].mesh.mesh(), scene.obstacles()[1].X_RB));
  EXPECT_GT(gap, 0.0);
  EXPECT_LE(gap, test::kDefaultTrial.closed_gap() + 1e-12);
}

TEST(Approach, ThatStartsInAnObstacleSaysSo) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const CompiledScene scene =
      compiled(hand, make_box({0.04, 0.04, 0.04}),
               {test::obstacle(make_box({0.1, 0.1, 0.05}), {0.0, 0.0, 0.4})});
  const ApproachResult result = approach_open(scene, from_above(hand, 0.4, 0.0));
  EXPECT_EQ(result.end, ApproachEnd::starts_in_collision);
  ASSERT_TRUE(result.touch.has_value());
  EXPECT_EQ(result.touch->body, BodyId::obstacle(0));
  EXPECT_EQ(result.travel, 0.0);
}

// Surfaces do not meet when one body is wholly inside the other.
TEST(Approach, SeesTheObjectInsideALinkAndTheHandInsideTheObject) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const ApproachMotion motion = from_above(hand, 0.03, 0.0);
  const TriangleMesh seed = block({0.004, 0.004, 0.004}, {0.0, 0.0, 0.06});
  EXPECT_EQ(approach_open(compiled(hand, seed), motion).end, ApproachEnd::starts_in_collision);
  const TriangleMesh mountain = make_box({2.0, 2.0, 2.0});
  EXPECT_EQ(approach_open(compiled(hand, mountain), motion).end, ApproachEnd::starts_in_collision);
  // Not the first component, and not the first vertex.
  TriangleMesh two = block({0.01, 0.01, 0.01}, {0.0, 0.0, -0.5});
  append(two, seed);
  EXPECT_EQ(approach_open(compiled(hand, two), motion).end, ApproachEnd::starts_in_collision);
}

TEST(Approach, SeesAnObstacleInsideALinkAndTheHandInsideAnObstacle) {
  const Robot hand = find_robot("parallel_jaw_wide");
  const TriangleMesh object = make_box({0.04, 0.04, 0.04});
  const ApproachMotion motion = from_above(hand, 0.3, 0.2);
  const auto end_with = [&](const TriangleMesh& mesh, const Vector3& at) {
    return approach_open(compiled(hand, object, {test::obstacle(mesh, at)}), motion);
  };
  for (const ApproachResult& result : {end_with(make_box({0.004, 0.004, 0.004}), {0.0, 0.0, 0.33}),
                                       end_with(make_box({1.0, 1.0, 0.5}), {0.0, 0.0, 0.33})}) {
    EXPECT_EQ(result.end, ApproachEnd::starts_in_collision);
    ASSERT_TRUE(result.touch.has_value());
    EXPECT_EQ(result.touch->body, BodyId::obstacle(0));
  }
  // A tray is open: what is over its floor is not inside it.
  TriangleMesh tray = make_box({1.0, 1.0, 1.0});
  std::erase_if(tray.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](int v) { return tray.vertices[static_cast<std::size_t>(v)].z() > 0.0; });
  });
  EXPECT_EQ(end_with(tray, {0.0, 0.0, 0.33}).end, ApproachEnd::stand_off);
}

// The palm touches, which would end the approach, and the fingers are in the box.
TEST(Approach, SeesFingersInTheObjectThatThePalmTouches) {
  const Robot hand = find_robot("barrett");
  const CompiledScene scene = compiled(hand, make_box({0.06, 0.06, 0.1}));
  const ApproachMotion down = from_above(hand, 0.3, -0.05);
  const ApproachResult open = approach_open(scene, down);
  ASSERT_EQ(open.end, ApproachEnd::touched_object);
  ASSERT_EQ(hand.links[index(open.touch->link)].name, "palm");
  ApproachMotion there = down;
  there.X_OH_end = down.at(open.travel);
  there.distance = 0.0;
  EXPECT_EQ(approach_open(scene, there).end, ApproachEnd::touched_object);
  const std::vector<double> closed = joint_values(hand, {0.0, 1.8, 1.8, 1.8});
  const ApproachResult result = approach(scene, closed, there, test::kDefaultTrial);
  EXPECT_EQ(result.end, ApproachEnd::starts_in_collision);
  EXPECT_NE(hand.links[index(result.touch->link)].name, "palm");
}

TEST(Approach, AVertexOfNoTriangleIsNotPartOfALink) {
  Robot hand = find_robot("parallel_jaw_wide");
  const double in_object = -0.5;
  hand.links[0].mesh.vertices.push_back({0.0, 0.0, in_object});
  const ApproachMotion motion = from_above(hand, 0.3, 0.2);
  // The stray vertex is 0.3 + 0.5 above the origin at the start.
  const CompiledScene scene = compiled(hand, block({0.1, 0.1, 0.1}, {0.0, 0.0, 0.8}));
  EXPECT_EQ(approach_open(scene, motion).end, ApproachEnd::stand_off);
}

TEST(Approach, LeavesClearancesBelowTheTrueGaps) {
  Random random(81);
  const Robot hand = find_robot("barrett");
  const CompiledScene scene = compiled(hand, make_sphere(0.05, 2));
  for (int i = 0; i < 20; ++i) {
    ApproachMotion motion;
    motion.X_OH_end = random.pose(0.1);
    motion.approach_O = motion.X_OH_end.linear() * hand.hand->approach;
    motion.distance = 0.4;
    const ApproachResult result = approach_open(scene, motion);
    if (result.end == ApproachEnd::starts_in_collision) continue;
    const auto gaps = test::object_gaps(scene, motion.at(result.travel), open_joints(hand));
    for (std::size_t l = 0; l < gaps.size(); ++l) {
      EXPECT_LE(result.object_clearance[l], gaps[l] + 1e-12) << i << " " << scene.links[l].name;
    }
  }
}

}  // namespace
}  // namespace prehend
