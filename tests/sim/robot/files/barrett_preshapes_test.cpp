// The widths and depths in the Barrett file, computed again from its joints and meshes as its
// README says.
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_file.h"
#include "tests/sim/robot/files/hand_shape.h"
#include "tests/support/turns.h"

namespace prehend {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr int kFingers = 3;
// Distal links stand upright where 40 + q + q / 3 = 90 degrees.
constexpr double kUpright = 37.5 * test::kDegree;

class Barrett {
 public:
  explicit Barrett(double spread) : spread_(spread) {}

  std::vector<double> dofs(const std::array<double, kFingers>& bend) const {
    return {spread_, bend[0], bend[1], bend[2]};
  }

  // Edge between the inner face of the distal link and the chamfer at its tip.
  Vector3 tip(int finger, double bend) const {
    const std::array<const char*, kFingers> names = {"distal_1", "distal_2", "distal_3"};
    const std::vector<Pose> X_BL = test::poses_at(robot_, dofs({bend, bend, bend}));
    for (std::size_t l = 0; l < X_BL.size(); ++l) {
      if (robot_.links[l].name == names[static_cast<std::size_t>(finger)]) {
        return X_BL[l] * (kMillimetre * Vector3(0.0, 10.73, 0.0));
      }
    }
    ADD_FAILURE() << "no distal link of finger " << finger;
    return Vector3::Zero();
  }

  // How far the tip is from the approach axis, in the direction from which the finger closes.
  double reach(int finger, double bend) const {
    const double side = finger == 0 ? 1.0 : -1.0;
    const Vector3 outward = finger == 2 ? Vector3(0.0, -1.0, 0.0)
                                        : Vector3(side * std::sin(spread_), std::cos(spread_), 0.0);
    return tip(finger, bend).dot(outward);
  }

  // The bend at which the tip is `radius` from the axis; reach falls all the way from upright.
  double bend_for(int finger, double radius) const {
    double open = kUpright;
    double closed = 140.0 * test::kDegree;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (open + closed);
      (reach(finger, middle) > radius ? open : closed) = middle;
    }
    return open;
  }

  std::array<double, kFingers> bends_for(double radius) const {
    return {bend_for(0, radius), bend_for(1, radius), bend_for(2, radius)};
  }

  double smallest_reach(double bend) const {
    return std::min({reach(0, bend), reach(1, bend), reach(2, bend)});
  }

  // Smallest ball on the approach axis that all tips touch while the fingers stay clear of each
  // other, to 1 mm.
  double smallest_radius() const {
    double radius = 0.0;
    while (!test::self_collisions(robot_, dofs(bends_for(radius))).empty()) radius += kMillimetre;
    return radius;
  }

  double mean_height(const std::array<double, kFingers>& bend) const {
    double sum = 0.0;
    for (int f = 0; f < kFingers; ++f) sum += tip(f, bend[static_cast<std::size_t>(f)]).z();
    return sum / kFingers;
  }

  const Robot& robot() const { return robot_; }

 private:
  Robot robot_ = find_robot("barrett");
  double spread_;
};

TEST(BarrettPreshapes, WidthsAndDepthsFollowFromTheFingers) {
  const Robot robot = find_robot("barrett");
  for (const Preshape& preshape : robot.hand->preshapes) {
    SCOPED_TRACE(preshape.name);
    const Barrett hand(preshape.dofs[0]);
    const double bend = std::max(preshape.dofs[3], kUpright);
    const double radius = hand.smallest_radius();
    EXPECT_NEAR(preshape.max_width, 2.0 * hand.smallest_reach(bend), kMillimetre);
    EXPECT_NEAR(preshape.min_width, 2.0 * radius, kMillimetre);
    EXPECT_NEAR(preshape.depth, hand.mean_height(hand.bends_for(radius)), kMillimetre);
  }
}

TEST(BarrettPreshapes, SpreadOfSixtyDegreesSpacesTheFingersEvenly) {
  const double spread = 60.0 * test::kDegree;
  const Vector3 sum = Vector3(std::sin(spread), std::cos(spread), 0.0) +
                      Vector3(-std::sin(spread), std::cos(spread), 0.0) + Vector3(0.0, -1.0, 0.0);
  EXPECT_LT(sum.norm(), 1e-15);
  // The same directions, from the links themselves: distal links bend about their z axes.
  const Barrett hand(spread);
  const std::vector<Pose> X_BL = test::poses_at(hand.robot(), hand.dofs({0.0, 0.0, 0.0}));
  Vector3 axes = Vector3::Zero();
  for (std::size_t l = 0; l < X_BL.size(); ++l) {
    if (hand.robot().links[l].name.starts_with("distal")) axes += X_BL[l].linear().col(2);
  }
  EXPECT_LT(axes.norm(), 1e-12);
}

// The fully closed hand comes to rest on itself or on the palm, not through its limits.
TEST(BarrettPreshapes, FingersMeetBeforeTheirLimits) {
  for (const double spread : {0.0, 45.0, 60.0, 90.0}) {
    const Barrett hand(spread * test::kDegree);
    const double limit = hand.robot().dofs[1].upper;
    EXPECT_NE(test::self_collisions(hand.robot(), hand.dofs({limit, limit, limit})), "") << spread;
  }
}

}  // namespace
}  // namespace prehend
