// The two-finger Robotiq with its linkage: from parallel to encompassing.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/robot/files/foreign_robot.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/trial/close_hand.h"
#include "tests/support/scenes.h"
#include "tests/support/shared_data.h"

namespace prehend {
namespace {

constexpr const char* kFile = "data/robots/public_hands/robotiq_2f85/2f85.xml";

const Robot& robotiq() {
  static const Robot hand =
      with_derived_hand(read_foreign_robot(test::shared(kFile))->robots[0].robot);
  return hand;
}

std::size_t link_named(const Robot& robot, const std::string& name) {
  return index(std::find_if(robot.links.begin(), robot.links.end(),
                            [&](const Link& link) { return link.name == name; }) -
               robot.links.begin());
}

std::size_t joint_named(const Robot& robot, const std::string& name) {
  return index(std::find_if(robot.joints.begin(), robot.joints.end(),
                            [&](const Joint& joint) { return joint.name == name; }) -
               robot.joints.begin());
}

// The angle by which the link has turned in the hand since the fingers were open [rad].
double turned(const std::string& link, const std::vector<double>& joints) {
  std::vector<Pose> X_open;
  std::vector<Pose> X;
  link_poses(robotiq(), joint_values(robotiq(), initial_dofs(robotiq())), X_open);
  link_poses(robotiq(), joints, X);
  const std::size_t l = link_named(robotiq(), link);
  return Eigen::AngleAxisd(X_open[l].linear().transpose() * X[l].linear()).angle();
}

// Closes on a body whose x axis is the closing direction and whose z axis is the approach, its
// middle `ahead` of the palm [m].
ClosedHand close_on(const CompiledScene& scene, double ahead, Pose& X_OH) {
  const Hand& hand = *robotiq().hand;
  Matrix3 R_HO;
  R_HO << hand.closing, hand.approach.cross(hand.closing), hand.approach;
  Pose X_HO = translation(hand.origin + ahead * hand.approach);
  X_HO.linear() = R_HO;
  X_OH = X_HO.inverse();
  ClosingStart start;
  start.X_OH = X_OH;
  start.dofs = hand.preshapes.front().dofs;
  return close_hand(scene, start, test::kDefaultTrial);
}

TEST(LinkageGrasps, ACardIsHeldBetweenParallelPads) {
  PREHEND_NEEDS_SHARED(kFile);
  const CompiledScene scene = test::compiled(robotiq(), make_box({0.001, 0.054, 0.04}));
  Pose X_OH;
  const ClosedHand closed = close_on(scene, robotiq().hand->preshapes.front().depth, X_OH);
  const std::vector<double> gaps = test::object_gaps(scene, X_OH, closed.joints);
  for (const std::string side : {"left", "right"}) {
    const double pad = std::min(gaps[link_named(robotiq(), side + "_pad")],
                                gaps[link_named(robotiq(), side + "_silicone_pad")]);
    EXPECT_LE(pad, test::kDefaultTrial.closed_gap() + 1e-12) << side;
    EXPECT_LT(turned(side + "_pad", closed.joints), 0.04) << side;
    // Nothing but the pads stopped the finger.
    const double spring = closed.joints[joint_named(robotiq(), side + "_spring_link_joint")];
    const double driver = closed.joints[joint_named(robotiq(), side + "_driver_joint")];
    EXPECT_NEAR(spring, driver, 1e-2) << side;
  }
}

TEST(LinkageGrasps, ACanDeepInTheHandIsEncompassed) {
  PREHEND_NEEDS_SHARED(kFile);
  const TriangleMesh can = transformed(
      make_cylinder(0.025, 0.1), Pose(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitX())));
  const CompiledScene scene = test::compiled(robotiq(), can);
  Pose X_OH;
  const ClosedHand closed = close_on(scene, 0.027, X_OH);
  const std::vector<double> gaps = test::object_gaps(scene, X_OH, closed.joints);
  for (const std::string side : {"left", "right"}) {
    const double pad = std::min({gaps[link_named(robotiq(), side + "_pad")],
                                 gaps[link_named(robotiq(), side + "_silicone_pad")],
                                 gaps[link_named(robotiq(), side + "_follower")]});
    EXPECT_LE(gaps[link_named(robotiq(), side + "_spring_link")], 2e-4) << side;
    EXPECT_LE(pad, 2e-4) << side;
    EXPECT_GT(turned(side + "_pad", closed.joints), 0.1) << side;
  }
}

// The angle of the bar from `pivot` of length `length` whose end is at the distance `far` of p,
// nearest to `near` [rad]; in the plane in which the finger moves.
double bar_angle(const Eigen::Vector2d& pivot, double length, const Eigen::Vector2d& p, double far,
                 double near) {
  const Eigen::Vector2d to = p - pivot;
  const double d = to.norm();
  const double half = std::acos((length * length + d * d - far * far) / (2.0 * length * d));
  const double middle = std::atan2(to.y(), to.x());
  const double a = middle + half;
  const double b = middle - half;
  return std::abs(a - near) < std::abs(b - near) ? a : b;
}

// The four-bar by hand, from the numbers of the file: driver and coupler are one bar, the spring
// link another, the follower joins them. Seen from the palm, y across and z ahead.
TEST(LinkageGrasps, TheFingerMovesAsItsFourBarDoes) {
  PREHEND_NEEDS_SHARED(kFile);
  const Robot& hand = robotiq();
  const Eigen::Vector2d driver(0.0306011, 0.054904);
  const Eigen::Vector2d spring(0.0132, 0.0609);
  const Eigen::Vector2d follower_joint(0.0132 + 0.055,
                                       0.0609 + 0.0375);  // its frame, with all at zero
  const Eigen::Vector2d hinge = follower_joint + Eigen::Vector2d(-0.018, 0.0065);
  const Eigen::Vector2d anchor = follower_joint;  // of the loop, on the follower
  const auto angle = [](const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); };
  const double rod = (anchor - driver).norm();
  const double bar = (hinge - spring).norm();
  const double lever = (anchor - hinge).norm();
  const auto base = std::find_if(hand.frames.begin(), hand.frames.end(),
                                 [](const RobotFrame& frame) { return frame.name == "base"; });
  ASSERT_NE(base, hand.frames.end());
  const Pose X_HB = base->X_AF;  // of the body in which the numbers are
  for (int i = 0; i <= 16; ++i) {
    const double d = hand.dofs[0].upper * i / 16.0;  // about +x: y turns to z
    const double at = angle(anchor - driver) + d;
    const Eigen::Vector2d p = driver + rod * Eigen::Vector2d(std::cos(at), std::sin(at));
    const double s = bar_angle(spring, bar, p, lever, angle(hinge - spring) + d);
    const Eigen::Vector2d h = spring + bar * Eigen::Vector2d(std::cos(s), std::sin(s));
    const double f = angle(p - h) - angle(anchor - hinge);
    const Eigen::Vector2d tip =
        hinge + Eigen::Vector2d(-0.02, 0.05);  // near the end of the pad, at the start
    const Eigen::Vector2d expected = h + Eigen::Rotation2Dd(f) * (tip - hinge);
    // Through the model: the link's point moves from there by the change of its pose.
    std::vector<Pose> X_zero;
    std::vector<Pose> X;
    link_poses(hand, std::vector<double>(hand.joints.size(), 0.0), X_zero);
    link_poses(hand, joint_values(hand, {d}), X);
    const std::size_t l = link_named(hand, "right_follower");
    const Pose X_BF = X_HB.inverse() * X[l];
    const Pose X_BF_zero = X_HB.inverse() * X_zero[l];
    const Vector3 moved = X_BF * (X_BF_zero.inverse() * Vector3(0.0, tip.x(), tip.y()));
    EXPECT_NEAR(moved.y(), expected.x(), 2e-4) << i;
    EXPECT_NEAR(moved.z(), expected.y(), 2e-4) << i;
  }
}

}  // namespace
}  // namespace prehend
