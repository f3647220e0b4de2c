// Bodies whose motion textbooks know.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/motion/energy.h"
#include "sim/motion/world.h"
#include "sim/shape/revolve.h"
#include "tests/support/sample_worlds.h"

namespace prehend {
namespace {

using test::kG;

// Friction slows a sliding sphere until it rolls, with 5/7 of its speed. The mesh is a sphere but
// for facets of 2 mm: each one that it tips over costs a little, 1.6 % until it rolls.
TEST(ClosedForms, ASlidingSphereEndsUpRollingAtFiveSevenths) {
  World world = test::world_with(
      {test::ground(), test::body_of("ball", make_sphere(0.05, 5), 1.0, {-1.0, 0.0, 0.0501})}, 0.3);
  RigidMotion& motion = world.bodies[1].motion;
  ASSERT_EQ(test::run(world, 0.05), StepOutcome::moved);
  motion.linear = {1.0, 0.0, 0.0};
  // Sliding ends after 2 v / (7 mu g) = 0.097 s.
  ASSERT_EQ(test::run(world, 0.1), StepOutcome::moved);
  EXPECT_NEAR(motion.linear.x(), 5.0 / 7.0, 0.02);
  EXPECT_NEAR(0.05 * motion.angular.y(), motion.linear.x(), 0.02);
}

// What rolls down a slope accelerates with 2/3 (cylinder) or 5/7 (ball) of g sin(angle). Gravity
// tilted by the angle stands for the slope.
TEST(ClosedForms, CylindersAndBallsRollDownASlope) {
  constexpr double kRadius = 0.03;
  const double angle = std::acos(-1.0) / 18.0;
  struct Case {
    TriangleMesh mesh;
    double part;
  };
  TriangleMesh lying = make_cylinder(kRadius, 0.06, 96);
  for (Vector3& p : lying.vertices) p = Vector3(p.x(), -p.z(), p.y());
  for (const Case& one : {Case{lying, 2.0 / 3.0}, Case{make_sphere(kRadius, 4), 5.0 / 7.0}}) {
    World world = test::world_with(
        {test::ground(), test::body_of("round", one.mesh, 0.5, {-1.0, 0.0, kRadius + 5e-5})}, 0.5);
    world.gravity = test::kG * Vector3(std::sin(angle), 0.0, -std::cos(angle));
    ASSERT_EQ(test::run(world, 1.0), StepOutcome::moved);
    const double expected = one.part * test::kG * std::sin(angle);
    EXPECT_NEAR(world.bodies[1].motion.linear.x(), expected, 0.01 * expected);
    RecordProperty("rolled_" + std::to_string(one.mesh.vertices.size()),
                   std::to_string(world.bodies[1].motion.linear.x() / expected));
  }
}

// Without friction a can that tips over on its rim is pushed straight up, and goes nowhere.
TEST(ClosedForms, ACanTipsOverItsRim) {
  constexpr double kTilt = 0.1;
  const Matrix3 turned = Eigen::AngleAxisd(kTilt, Vector3::UnitY()).toRotationMatrix();
  World world = test::world_with(
      {test::ground(), test::body_of("can", make_cylinder(0.03, 0.1, 96), 0.3, Vector3::Zero())},
      0.0);
  RigidMotion& motion = world.bodies[1].motion;
  const double low = (turned * Vector3(0.03, 0.0, -0.05)).z();
  motion.X_WB = pose_from(turned, Vector3(0.0, 0.0, 5e-5 - low));
  ASSERT_EQ(test::run(world, 0.02), StepOutcome::moved);
  EXPECT_GT(motion.angular.norm(), 0.1);
  EXPECT_LT(motion.linear.head<2>().norm(), 1e-6);
}

// A ball that rolls in a bowl swings with the period 2 pi sqrt(7 (R - r) / (5 g)) about the bottom,
// and keeps its amplitude.
TEST(ClosedForms, ABallRollsInABowl) {
  constexpr double kRadius = 0.02;
  constexpr double kBowl = 0.1;
  // Half a hollow ball, with walls of 10 mm.
  std::vector<Eigen::Vector2d> profile;
  constexpr int kParts = 60;
  const double right = 0.5 * std::acos(-1.0);
  for (int i = 0; i <= kParts; ++i) {
    const double angle = right * i / kParts;
    profile.emplace_back((kBowl + 0.01) * std::sin(angle), -(kBowl + 0.01) * std::cos(angle));
  }
  for (int i = kParts; i >= 0; --i) {
    const double angle = right * i / kParts;
    profile.emplace_back(kBowl * std::sin(angle), -kBowl * std::cos(angle));
  }
  WorldBody bowl = test::body_of("bowl", revolve(profile, 3e-3).mesh, 1.0, Vector3::Zero());
  bowl.is_fixed = true;
  const double start = 0.3;
  const double way = kBowl - kRadius - 1e-4;
  World world =
      test::world_with({bowl, test::body_of("ball", make_sphere(kRadius, 4), 0.1,
                                            {way * std::sin(start), 0.0, -way * std::cos(start)})},
                       0.8);
  double time = 0.0;
  double farthest = 0.0;  // in the third second
  std::vector<double> passes;
  double last = start;
  while (time < 3.0) {
    const StepResult result = step_world(world);
    ASSERT_EQ(result.outcome, StepOutcome::moved);
    time += result.time;
    const Vector3 at = world.bodies[1].motion.X_WB.translation();
    const double angle = std::atan2(at.x(), -at.z());
    if (last > 0.0 && angle <= 0.0) passes.push_back(time);
    if (time > 2.0) farthest = std::max(farthest, angle);
    last = angle;
  }
  ASSERT_GE(passes.size(), 3U);
  const double period = (passes.back() - passes.front()) / static_cast<double>(passes.size() - 1);
  // A pendulum at this amplitude is slower than a small one by 1 + a^2 / 16.
  const double exact =
      4.0 * right * std::sqrt(1.4 * (kBowl - kRadius) / test::kG) * (1.0 + start * start / 16.0);
  EXPECT_NEAR(period, exact, 0.01 * exact);
  EXPECT_GT(farthest, 0.95 * start);
  EXPECT_LT(farthest, 1.01 * start);
  RecordProperty("amplitude", std::to_string(farthest / start));
  RecordProperty("period", std::to_string(period / exact));
}

// Five balls of which one arrives: the last one leaves with its velocity, the others stay, although
// they touch.
TEST(ClosedForms, NewtonsCradlePassesTheVelocityOn) {
  for (const int arriving : {1, 2}) {
    std::vector<WorldBody> balls;
    for (int i = 0; i < 5; ++i) {
      const double gap = i < arriving ? -0.02 : 0.0;
      balls.push_back(test::body_of("ball" + std::to_string(i), make_box(Vector3::Constant(0.1)),
                                    0.5, {0.10005 * i + gap, 0.0, 0.0}));
      balls.back().restitution = 1.0;
      if (i < arriving) balls.back().motion.linear.x() = 1.0;
    }
    World world = test::world_with(std::move(balls), 0.0);
    world.gravity.setZero();
    ASSERT_EQ(test::run(world, 0.1), StepOutcome::moved);
    for (int i = 0; i < 5; ++i) {
      EXPECT_NEAR(world.bodies[static_cast<std::size_t>(i)].motion.linear.x(),
                  i >= 5 - arriving ? 1.0 : 0.0, 1e-6)
          << arriving << " " << i;
    }
    EXPECT_NEAR(energy_of(world), arriving * 0.25, 1e-6);
  }
}

// Two cards of length l lean against each other at an angle from the vertical: each foot bears the
// weight of a card, and the moment about the top asks for friction of tan(angle) / 2 of it.
TEST(ClosedForms, ACardHouseStandsByItsFriction) {
  constexpr double kLength = 0.09;
  constexpr double kThick = 0.001;
  const double angle = 0.4;
  for (const double part : {0.9, 1.1}) {
    std::vector<WorldBody> bodies = {test::ground()};
    for (const double side : {-1.0, 1.0}) {
      const Matrix3 turned = Eigen::AngleAxisd(-side * angle, Vector3::UnitY()).toRotationMatrix();
      bodies.push_back(test::box(side < 0.0 ? "left" : "right", {kThick, 0.06, kLength}, 0.002,
                                 Vector3::Zero()));
      // The inner upper edges meet in the middle.
      const Vector3 corner = turned * Vector3(-side * 0.5 * kThick, 0.0, 0.5 * kLength);
      const Vector3 foot = turned * Vector3(-side * 0.5 * kThick, 0.0, -0.5 * kLength);
      bodies.back().motion.X_WB =
          pose_from(turned, Vector3(side * 2.5e-5 - corner.x(), 0.0, 5e-5 - foot.z()));
    }
    World world = test::world_with(std::move(bodies), part * 0.5 * std::tan(angle));
    const Vector3 start = world.bodies[2].motion.X_WB.translation();
    ASSERT_EQ(test::run(world, 1.0), StepOutcome::moved);
    const double moved = (world.bodies[2].motion.X_WB.translation() - start).norm();
    if (part > 1.0) {
      EXPECT_LT(moved, 2e-4);
    } else {
      EXPECT_GT(moved, 0.01);
    }
  }
}

// Painleve's rod: pushed along a rough plane at an angle where forces alone have no consistent
// solution (mu > 4/3). Time stepping finds an impulse, or says that it did not; the rod never
// hangs, nor goes through the plane.
TEST(ClosedForms, PainlevesRodGoesOn) {
  for (const double friction : {0.3, 1.5, 3.0}) {
    for (const double degrees : {20.0, 45.0, 60.0, 80.0}) {
      const double angle = degrees * std::acos(-1.0) / 180.0;
      constexpr double kLength = 0.4;
      World world = test::world_with(
          {test::ground(), test::box("rod", {kLength, 0.01, 0.004}, 0.1, Vector3::Zero())},
          friction);
      const Matrix3 turned = Eigen::AngleAxisd(angle, Vector3::UnitY()).toRotationMatrix();
      RigidMotion& motion = world.bodies[1].motion;
      const Vector3 low = turned * Vector3(0.5 * kLength, 0.0, -0.002);
      motion.X_WB = pose_from(turned, Vector3(-1.0, 0.0, 1e-4 - low.z()));
      motion.linear = {2.0, 0.0, 0.0};
      double before = energy_of(world);
      double time = 0.0;
      for (int step = 0; step < 4000 && time < 1.0; ++step) {
        const StepResult result = step_world(world);
        ASSERT_TRUE(result.outcome == StepOutcome::moved ||
                    result.outcome == StepOutcome::not_converged)
            << friction << " " << degrees << " " << name_of(result.outcome);
        time += result.time;
        const double after = energy_of(world);
        EXPECT_LT(after, before + 1e-4) << friction << " " << degrees << " at " << time;
        before = after;
      }
      EXPECT_GE(time, 1.0 - 1e-9);
      EXPECT_GT(motion.X_WB.translation().z(), 0.0) << friction << " " << degrees;
      EXPECT_LT(motion.linear.norm(), 1e-3);
    }
  }
}

}  // namespace
}  // namespace prehend
