// Closing: who stops whom, and that fingers stop in time.
#include "sim/trial/close_hand.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/object_generator.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

using test::block;
using test::compiled;
using test::finger_hand;

ClosedHand close_from(const CompiledScene& scene, const Pose& X_OH, std::vector<double> dofs,
                      std::vector<double> object_clearance = {}) {
  ClosingStart start;
  start.X_OH = X_OH;
  start.dofs = std::move(dofs);
  start.object_clearance = std::move(object_clearance);
  return close_hand(scene, start, test::kDefaultTrial);
}

// In the way of the proximal bar, of the distal bar only, and of nothing.
const Vector3 kBySide(0.015, 0.035, 0.0);
const Vector3 kByTip(0.06, 0.075, 0.0);
const Vector3 kFarAway(0.0, -1.0, 0.0);

CompiledScene finger_scene(Coupling coupling, const Vector3& object_at) {
  return compiled(finger_hand(coupling), block({0.02, 0.02, 0.02}, object_at));
}

void expect_touches(const CompiledScene& scene, const Pose& X_OH, const ClosedHand& closed,
                    std::size_t link) {
  const double gap = test::object_gaps(scene, X_OH, closed.joints)[link];
  EXPECT_GT(gap, 0.0);
  EXPECT_LE(gap, test::kDefaultTrial.closed_gap() + 1e-12) << scene.links[link].name;
}

TEST(CloseHand, JointsEndAtTheirLimitsWhenNothingIsTouched) {
  const CompiledScene scene = finger_scene(Coupling::breakaway, kFarAway);
  const ClosedHand closed = close_from(scene, Pose::Identity(), {0.0});
  EXPECT_DOUBLE_EQ(closed.joints[0], 1.5);
  EXPECT_DOUBLE_EQ(closed.joints[1], 0.75);
  EXPECT_DOUBLE_EQ(closed.dofs[0], 1.5);
  EXPECT_FALSE(closed.stopped_by_contact[0] || closed.stopped_by_contact[1]);
}

TEST(CloseHand, TheDistalJointGoesOnWhenTheProximalOneIsStopped) {
  const CompiledScene scene = finger_scene(Coupling::breakaway, kBySide);
  const ClosedHand closed = close_from(scene, Pose::Identity(), {0.0});
  EXPECT_TRUE(closed.stopped_by_contact[0]);
  expect_touches(scene, Pose::Identity(), closed, 1);
  EXPECT_LT(closed.joints[0], 1.0);
  EXPECT_GT(closed.joints[1], 0.5 * closed.joints[0] + 0.1);
  EXPECT_NEAR(closed.dofs[0], closed.joints[1] / 0.5, 1e-12);  // as far as what went farthest
}

TEST(CloseHand, AStoppedDistalLinkStopsTheProximalJointToo) {
  const CompiledScene scene = finger_scene(Coupling::breakaway, kByTip);
  const ClosedHand closed = close_from(scene, Pose::Identity(), {0.0});
  EXPECT_TRUE(closed.stopped_by_contact[0] && closed.stopped_by_contact[1]);
  EXPECT_NEAR(closed.joints[1], 0.5 * closed.joints[0], 1e-12);
  EXPECT_LT(closed.joints[0], 1.5);
  expect_touches(scene, Pose::Identity(), closed, 2);
  EXPECT_GT(test::object_gaps(scene, Pose::Identity(), closed.joints)[1], 1e-3);
}

TEST(CloseHand, ARigidDegreeOfFreedomStopsWhole) {
  const CompiledScene scene = finger_scene(Coupling::rigid, kBySide);
  const ClosedHand closed = close_from(scene, Pose::Identity(), {0.0});
  EXPECT_TRUE(closed.stopped_by_contact[0] && closed.stopped_by_contact[1]);
  EXPECT_NEAR(closed.joints[1], 0.5 * closed.joints[0], 1e-12);
  EXPECT_NEAR(closed.dofs[0], closed.joints[0], 1e-12);
  expect_touches(scene, Pose::Identity(), closed, 1);
}

// A block in the way of the left finger only: its linkage stops as a whole, the right one goes on.
TEST(CloseHand, OneFingerOfTwoOnALinkageStopsWhole) {
  const Robot hand = find_robot("robotiq_2f85");
  const CompiledScene scene = compiled(hand, block({0.02, 0.02, 0.02}, {0.03, 0.0, 0.135}));
  const ClosedHand closed = close_from(scene, Pose::Identity(), {0.0});
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_TRUE(closed.stopped_by_contact[j]) << hand.joints[j].name;
    EXPECT_FALSE(closed.stopped_by_contact[j + 3]) << hand.joints[j + 3].name;
    EXPECT_NEAR(closed.joints[j], hand.joints[j].ratio * closed.joints[0], 1e-12);
    EXPECT_NEAR(closed.joints[j + 3], hand.joints[j + 3].ratio * hand.dofs[0].upper, 1e-12);
  }
  EXPECT_GT(closed.joints[0], 0.01);
  EXPECT_LT(closed.joints[0], 0.1);
}

// A linkage keeps the distal bar parallel until the proximal one is stopped, and then turns it in.
CompiledScene linkage_scene(const Vector3& object_at) {
  Robot hand = finger_hand(Coupling::by_finger);
  Joint& distal = hand.joints[1];
  distal.ratio = -1.0;
  distal.lower = -1.5;
  distal.across = 0;
  distal.ahead = 2.5;
  return compiled(hand, block({0.02, 0.02, 0.02}, object_at));
}

TEST(CloseHand, ALinkageClosesFurtherWhenItsFirstLinkIsStopped) {
  const CompiledScene scene = linkage_scene(kBySide);
  const ClosedHand closed = close_from(scene, Pose::Identity(), {0.0});
  EXPECT_TRUE(closed.stopped_by_contact[0]);
  expect_touches(scene, Pose::Identity(), closed, 1);
  const double behind = closed.dofs[0] - closed.joints[0];
  EXPECT_GT(behind, 0.1);
  EXPECT_NEAR(closed.joints[1], -closed.dofs[0] + 2.5 * behind, 1e-9);
  // Beyond the block the distal bar ends where the drive does, or at its own limit.
  EXPECT_TRUE(std::abs(closed.dofs[0] - 1.5) < 1e-9 || std::abs(closed.joints[1] - 1.5) < 1e-9 ||
              closed.stopped_by_contact[1]);
}

TEST(CloseHand, ALinkageStopsWholeWhereItsLastLinkTouches) {
  const CompiledScene scene = linkage_scene({0.06, 0.06, 0.0});
  const ClosedHand closed = close_from(scene, Pose::Identity(), {0.0});
  ASSERT_TRUE(closed.stopped_by_contact[0] && closed.stopped_by_contact[1]);
  EXPECT_NEAR(closed.joints[1], -closed.joints[0], 1e-12);
  expect_touches(scene, Pose::Identity(), closed, 2);
}

TEST(CloseHand, GoesOnFromJointsThatHaveParted) {
  const CompiledScene scene = finger_scene(Coupling::breakaway, kBySide);
  const ClosedHand once = close_from(scene, Pose::Identity(), {0.0});
  ClosingStart start;
  start.dofs = once.dofs;
  start.joints = once.joints;
  const ClosedHand again = close_hand(scene, start, test::kDefaultTrial);
  for (std::size_t j = 0; j < again.joints.size(); ++j) {
    EXPECT_NEAR(again.joints[j], once.joints[j], 1e-4);
  }
}

TEST(CloseHand, FingersStopOnEachOther) {
  for (const char* name : {"parallel_jaw", "parallel_jaw_wide", "franka_hand", "barrett"}) {
    const Robot hand = find_robot(name);
    const CompiledScene scene = compiled(hand, block({0.01, 0.01, 0.01}, {0.0, 0.0, -1.0}));
    for (std::size_t s = 0; s < hand.hand->preshapes.size(); ++s) {
      ClosingStart start;
      start.dofs = hand.hand->preshapes[s].dofs;
      // What is known about the gaps at the start must not change where they end.
      for (const bool known : {false, true}) {
        start.self_clearance = known ? scene.preshape_gaps[s] : std::vector<double>{};
        const ClosedHand closed = close_hand(scene, start, test::kDefaultTrial);
        EXPECT_EQ(test::collision(scene, Pose::Identity(), closed.joints), "") << name << " " << s;
        const auto links = test::link_soups(scene, Pose::Identity(), closed.joints);
        double least = 1.0;
        for (const LinkPair& pair : scene.self_pairs) {
          least = std::min(least, test::surface_gap(links[static_cast<std::size_t>(pair.a)],
                                                    links[static_cast<std::size_t>(pair.b)]));
        }
        EXPECT_GT(least, 0.0);
        EXPECT_LE(least, test::kDefaultTrial.closed_gap() + 1e-12) << name << " " << s;
      }
    }
  }
}

TEST(CloseHand, StopsAtObstaclesAndTheStillLinksStay) {
  const Robot hand = find_robot("parallel_jaw");
  const CompiledScene scene =
      compiled(hand, block({0.01, 0.01, 0.01}, {0.0, 0.0, -1.0}),
               {test::obstacle(make_box({0.01, 0.2, 0.01}), {0.02, 0.0, 0.06})});
  const ClosedHand closed = close_from(scene, Pose::Identity(), {0.04, 0.04});
  EXPECT_EQ(test::collision(scene, Pose::Identity(), closed.joints), "");
  const auto links = test::link_soups(scene, Pose::Identity(), closed.joints);
  const auto bar = test::soup(scene.obstacles()[0].mesh.mesh(), scene.obstacles()[0].X_RB);
  EXPECT_LE(test::surface_gap(links[1], bar), test::kDefaultTrial.closed_gap() + 1e-12)
      << "the plate on the obstacle's side";
  EXPECT_EQ(links[0][0][0], test::soup(scene.links[0].mesh.mesh())[0][0]) << "the palm moved";
}

// Clearances are only there to save queries: none, too small and true ones give one result.
TEST(CloseHand, DoesNotDependOnHowLooseTheClearancesAre) {
  const Robot hand = find_robot("barrett");
  const CompiledScene scene = compiled(hand, generate_object("ball", 500));
  const Vector3 middle = scene.object().mesh.ball_center();
  for (std::size_t s = 0; s < hand.hand->preshapes.size(); ++s) {
    const std::vector<double> dofs = hand.hand->preshapes[s].dofs;
    const Pose X_OH = translation(middle - Vector3(0.003, 0.002, 0.085));
    std::vector<double> gaps = test::object_gaps(scene, X_OH, joint_values(hand, dofs));
    const ClosedHand none = close_from(scene, X_OH, dofs);
    EXPECT_EQ(test::collision(scene, X_OH, none.joints), "");
    for (const double part : {0.0, 0.3, 0.77, 1.0}) {
      std::vector<double> loose = gaps;
      for (double& gap : loose) gap *= part;
      const ClosedHand closed = close_from(scene, X_OH, dofs, loose);
      for (std::size_t j = 0; j < closed.joints.size(); ++j) {
        // Links end at gaps that differ by a tenth of 0.05 mm at most; at 125 mm from the palm,
        // 1e-4 rad is more than twice that.
        EXPECT_NEAR(closed.joints[j], none.joints[j], 1e-4) << "preshape " << s << " joint " << j;
      }
    }
  }
}

// The gap of a thin sheet is small only for an instant of the motion.
TEST(CloseHand, DoesNotJumpThroughASheet) {
  Random random(101);
  const TriangleMesh sheet = make_box({0.06, 0.0002, 0.06});
  const Robot finger = finger_hand(Coupling::breakaway);
  int tried = 0;
  for (int i = 0; i < 120; ++i) {
    const double angle = random.uniform(0.3, 1.4);
    const double away = random.uniform(0.03, 0.09);
    const double tilt = random.uniform(-0.4, 0.4);
    const Pose X_OS = Pose(Eigen::AngleAxisd(angle, Vector3::UnitZ())) *
                      translation({away, 0.0, 0.0}) *
                      Pose(Eigen::AngleAxisd(tilt, random.direction()));
    const CompiledScene scene = compiled(finger, transformed(sheet, X_OS));
    if (!test::collision(scene, Pose::Identity(), {0.0, 0.0}).empty()) continue;
    ++tried;
    const ClosedHand closed = close_from(scene, Pose::Identity(), {0.0});
    ASSERT_EQ(test::collision(scene, Pose::Identity(), closed.joints), "") << "sheet " << i;
    ASSERT_TRUE(closed.stopped_by_contact[0] || closed.stopped_by_contact[1]) << "sheet " << i;
    ASSERT_LT(closed.joints[0], angle + 0.4) << "sheet " << i;
  }
  EXPECT_GT(tried, 50);
}

TEST(CloseHand, StopsAtOnceWhereItAlreadyTouches) {
  const Robot hand = find_robot("parallel_jaw");
  const CompiledScene scene = compiled(hand, block({0.03, 0.03, 0.03}, {0.0, 0.0, 0.06}));
  const double at = 0.015 + 4e-5;
  const ClosedHand closed = close_from(scene, Pose::Identity(), {at, 0.04});
  EXPECT_EQ(closed.joints[0], at);
  EXPECT_TRUE(closed.stopped_by_contact[0]);
  EXPECT_NEAR(closed.joints[1], 0.015 + test::kDefaultTrial.contact_gap,
              0.1 * test::kDefaultTrial.contact_gap + 1e-12);
}

}  // namespace
}  // namespace prehend
