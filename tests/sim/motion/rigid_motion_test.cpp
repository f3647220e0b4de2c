#include "sim/motion/rigid_motion.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace prehend {
namespace {

const Inertial kBook{2.0, {0.01, -0.02, 0.03}, Vector3(1.0, 2.0, 3.0).asDiagonal()};

// Turns freely for so many steps, its angular momentum kept.
RigidMotion spun(const RigidMotion& before, const Vector3& momentum, double step, int steps) {
  RigidMotion motion = before;
  for (int i = 0; i < steps; ++i) {
    motion.angular = free_angular_velocity(kBook, motion.X_WB, momentum, step);
    motion.X_WB = carried(kBook, motion, step);
  }
  motion.angular = inertia_in_world(kBook, motion.X_WB).ldlt().solve(momentum);
  return motion;
}

TEST(RigidMotion, AFreeBodyKeepsItsEnergy) {
  RigidMotion motion;
  motion.angular = {0.5, 3.0, -1.0};
  const Vector3 momentum = kBook.inertia * motion.angular;
  const double energy = kinetic_energy(kBook, motion);
  double most = 0.0;
  for (int i = 0; i < 1000; ++i) {
    motion = spun(motion, momentum, 2.5e-3, 100);
    most = std::max(most, std::abs(kinetic_energy(kBook, motion) - energy));
  }
  EXPECT_LT(most, 1e-4 * energy);
  EXPECT_LT((motion.X_WB.linear() * motion.X_WB.linear().transpose() - Matrix3::Identity()).norm(),
            1e-14);
  EXPECT_LT(center_in_world(kBook, motion.X_WB).norm() - kBook.center_of_mass.norm(), 1e-12);
}

// Dzhanibekov: spun about the middle axis, a body turns over and over. Of the exact solution, the
// time between two turns is 4 K(m) / w with the complete elliptic integral (Landau and Lifshitz,
// Mechanics, section 37); here by the energy and momentum of the start.
TEST(RigidMotion, SpunAboutTheMiddleAxisItTurnsOver) {
  const Vector3 start(1e-3, 4.0, 0.0);
  const Vector3 momentum = kBook.inertia * start;
  RigidMotion motion;
  motion.angular = start;
  int turns = 0;
  bool up = true;
  constexpr double step = 1e-3;
  for (int i = 0; i < 40000; ++i) {
    motion = spun(motion, momentum, step, 1);
    const bool now_up = (motion.X_WB.linear().transpose() * motion.angular).y() > 0.0;
    if (now_up != up) ++turns;
    up = now_up;
  }
  // Period of the components in the body: T = 4 K / sqrt((I3 - I2)(L^2 - 2 E I1) / (I1 I2 I3)),
  // with m = (I2 - I1)(2 E I3 - L^2) / ((I3 - I2)(L^2 - 2 E I1)); K by the arithmetic-geometric
  // mean.
  const double energy2 = start.dot(momentum);
  const double l2 = momentum.squaredNorm();
  double fast = (3.0 - 2.0) * (l2 - energy2 * 1.0);
  double slow = (2.0 - 1.0) * (energy2 * 3.0 - l2);
  if (slow > fast) std::swap(fast, slow);
  const double m = slow / fast;
  double a = 1.0;
  double b = std::sqrt(1.0 - m);
  for (int i = 0; i < 30; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  const double quarter = std::acos(-1.0) / (2.0 * a);
  const double half_period = 2.0 * quarter / std::sqrt(fast / 6.0);
  EXPECT_NEAR(turns, 40.0 / half_period, 1.0);
  EXPECT_GE(turns, 5);
}

TEST(RigidMotion, OrderOfTheRotationIsTwo) {
  const Vector3 start(0.5, 3.0, -1.0);
  const Vector3 momentum = kBook.inertia * start;
  RigidMotion motion;
  motion.angular = start;
  const auto reached = [&](int steps) {
    return Matrix3(spun(motion, momentum, 1.0 / steps, steps).X_WB.linear());
  };
  const Matrix3 exact = reached(6400);
  const double coarse = (reached(100) - exact).norm();
  const double fine = (reached(200) - exact).norm();
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

}  // namespace
}  // namespace prehend
