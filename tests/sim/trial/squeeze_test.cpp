// Which way an object begins to move between two fingers, against closed forms.
#include "sim/trial/squeeze.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace prehend {
namespace {

constexpr double kPadFriction = 0.3;

CompiledScene box_scene() {
  return test::compiled(find_robot("franka_hand"), make_box({0.02, 0.06, 0.04}));
}

FingerPair fingers_of(const CompiledScene& scene) { return finger_pair(scene.scene.hand, 0); }

// The link whose own joint is `joint`.
LinkId link_of(const CompiledScene& scene, int joint) {
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const std::vector<int>& joints = scene.links[l].joints;
    if (std::find(joints.begin(), joints.end(), joint) != joints.end()) return link_id(l);
  }
  return {};
}

// A contact of one finger. The first finger is the one that opens along +x of the hand, whose frame
// is that of the object here: it presses along -x.
struct Touch {
  bool first = true;
  Vector3 position = Vector3::Zero();
  Vector3 normal = Vector3::UnitX();
};

Trial pressed(const CompiledScene& scene, const std::vector<Touch>& touches) {
  const FingerPair fingers = fingers_of(scene);
  Trial trial;
  trial.outcome = Outcome::not_force_closure;
  trial.dofs = scene.scene.hand.hand->preshapes[0].dofs;
  trial.joints = joint_values(scene.scene.hand, trial.dofs);
  const Vector3 opening = opening_axis(scene.scene.hand, fingers, trial.joints);
  // The opening axis of the first finger becomes the object's x axis.
  trial.X_OH.linear() =
      Eigen::Quaterniond::FromTwoVectors(opening, Vector3::UnitX()).toRotationMatrix();
  for (const Touch& touch : touches) {
    GraspContact contact;
    contact.link = link_of(scene, touch.first ? fingers.first : fingers.second);
    contact.point = {touch.position, touch.normal.normalized(), kPadFriction};
    trial.contacts.push_back(contact);
  }
  return trial;
}

constexpr SqueezeLimits kLimits{
    .slide = 2e-3, .angle = 0.05, .least_force = 1e-2, .least_arm = 1e-4};

TEST(Squeeze, OpposedForcesMoveNothing) {
  const CompiledScene scene = box_scene();
  for (const double y : {0.0, 0.02}) {
    const Trial trial = pressed(scene, {{true, {0.01, y, 0.01}, -Vector3::UnitX()},
                                        {false, {-0.01, y, 0.01}, Vector3::UnitX()}});
    EXPECT_FALSE(squeezed(scene, fingers_of(scene), trial, kLimits)) << y;
  }
}

TEST(Squeeze, ForcesBesideEachOtherTurnTheObject) {
  const CompiledScene scene = box_scene();
  const Trial trial = pressed(scene, {{true, {0.01, 0.005, 0.0}, -Vector3::UnitX()},
                                      {false, {-0.01, -0.005, 0.0}, Vector3::UnitX()}});
  const auto motion = squeezed(scene, fingers_of(scene), trial, kLimits);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->linear_O.norm(), 0.0, 1e-12);
  // -x at y > 0 and +x at y < 0 turn from x to y.
  EXPECT_NEAR(motion->angular_O.z(), kLimits.angle, 1e-12);
  EXPECT_NEAR(motion->angular_O.head<2>().norm(), 0.0, 1e-12);
}

TEST(Squeeze, AFingerThatDoesNotTouchMeansNoMotion) {
  const CompiledScene scene = box_scene();
  const Trial trial = pressed(scene, {{true, {0.01, 0.01, 0.0}, -Vector3::UnitX()}});
  EXPECT_FALSE(squeezed(scene, fingers_of(scene), trial, kLimits));
}

// A wedge whose faces are inclined by `angle` to the line of the fingers, which press at the centre
// of mass.
Trial wedge(const CompiledScene& scene, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return pressed(scene,
                 {{true, {0.01, 0.0, 0.0}, {-c, 0.0, s}}, {false, {-0.01, 0.0, 0.0}, {c, 0.0, s}}});
}

TEST(Squeeze, AWedgeSlidesOutFromTheAngleOfFriction) {
  const CompiledScene scene = box_scene();
  const double limit = std::atan(kPadFriction);
  EXPECT_FALSE(squeezed(scene, fingers_of(scene), wedge(scene, limit - 1e-3), kLimits));
  const auto motion = squeezed(scene, fingers_of(scene), wedge(scene, limit + 0.02), kLimits);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->linear_O.z(), kLimits.slide, 1e-12);
  EXPECT_NEAR(motion->angular_O.norm(), 0.0, 1e-9);
}

// One face inclined only: the force F of that finger beyond the line of the fingers acts at p =
// (0.01, 0, 0), the middle of the contacts is the centre of mass, and the couple there is M = p x F
// = (0, -0.01 F, 0). The moments of inertia of a box of 1 kg are (b^2 + c^2) / 12 and so on, their
// mean (a^2 + b^2 + c^2) / 18.
TEST(Squeeze, MassAndInertiaShareTheMotion) {
  const CompiledScene scene = box_scene();
  const Trial trial = pressed(scene, {{true, {0.01, 0.0, 0.0}, {-1.0, 0.0, 1.0}},
                                      {false, {-0.01, 0.0, 0.0}, Vector3::UnitX()}});
  const auto motion = squeezed(scene, fingers_of(scene), trial, kLimits);
  ASSERT_TRUE(motion);
  ASSERT_GT(motion->linear_O.z(), 0.0);
  const double inertia = (0.02 * 0.02 + 0.06 * 0.06 + 0.04 * 0.04) / 18.0;
  EXPECT_NEAR(motion->angular_O.y() / motion->linear_O.z(), -0.01 / inertia, 1e-9 / inertia);
  EXPECT_NEAR(motion->linear_O.head<2>().norm(), 0.0, 1e-12);
}

TEST(Squeeze, TheMotionIsAsLargeAsTheLimitsAllow) {
  const CompiledScene scene = box_scene();
  for (const double slide : {1e-4, 2e-3, 5e-2}) {
    SqueezeLimits limits = kLimits;
    limits.slide = slide;
    const Trial trial = pressed(scene, {{true, {0.01, 0.002, 0.01}, {-1.0, 0.2, 1.0}},
                                        {false, {-0.01, 0.0, 0.0}, Vector3::UnitX()}});
    const auto motion = squeezed(scene, fingers_of(scene), trial, limits);
    ASSERT_TRUE(motion);
    const double farthest =
        std::max(motion->at({0.01, 0.002, 0.01}).norm(), motion->at({-0.01, 0.0, 0.0}).norm());
    const double size = std::max(farthest / limits.slide, motion->angular_O.norm() / limits.angle);
    EXPECT_NEAR(size, 1.0, 1e-12);
  }
}

TEST(Squeeze, TheHandMovesTheOppositeWay) {
  ObjectMotion motion;
  motion.center_O = {0.01, -0.02, 0.03};
  motion.linear_O = {2e-4, -1e-4, 3e-4};
  motion.angular_O = {1e-3, 2e-3, -3e-3};
  const Pose X_OH = translation({0.1, 0.2, -0.1}) * Eigen::AngleAxisd(0.7, Vector3::UnitY());
  const Pose X_OH_after = after(motion, X_OH);
  for (const Vector3& p_O : {Vector3(0.05, 0.0, 0.0), Vector3(-0.02, 0.04, 0.01)}) {
    const Vector3 moved_H = X_OH_after.inverse() * p_O;
    const Vector3 expected_H = X_OH.inverse() * (p_O + motion.at(p_O));
    // Turns are exact there and first order here: they differ by angle^2 / 2 times the distance.
    EXPECT_LT((moved_H - expected_H).norm(), 1e-6);
  }
}

}  // namespace
}  // namespace prehend
