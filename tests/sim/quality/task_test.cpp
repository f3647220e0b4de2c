#include "sim/quality/task.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

constexpr double kFriction = 0.5;

WrenchSpaceOptions exact(WrenchNorm norm) {
  WrenchSpaceOptions space;
  space.norm = norm;
  space.cone = FrictionCone::exact;
  return space;
}

void expect_near(const Interval& interval, double value) {
  EXPECT_LE(interval.lower, value * (1.0 + 1e-9));
  EXPECT_GE(interval.upper, value * (1.0 - 1e-9));
  EXPECT_NEAR(interval.lower, value, 1e-5 * value);
  EXPECT_NEAR(interval.upper, value, 1e-5 * value);
}

// Two opposite fingers carry 2 mu of weight with unit forces each, mu with forces that sum to one.
TEST(TaskResistance, WeightBetweenTwoFingers) {
  const Contacts pinch = ring_grasp(2, kFriction);
  const Task gravity = TaskGravity{-Eigen::Vector3d::UnitZ(), 1.0};
  expect_near(task_resistance(pinch, {}, gravity, exact(WrenchNorm::linf)), 2.0 * kFriction);
  expect_near(task_resistance(pinch, {}, gravity, exact(WrenchNorm::l1)), kFriction);
  const Task heavier = TaskGravity{-7.0 * Eigen::Vector3d::UnitZ(), 4.0};
  expect_near(task_resistance(pinch, {}, heavier, exact(WrenchNorm::l1)), kFriction / 4.0);
}

TEST(TaskResistance, IsThatOfTheWorstWrench) {
  const Contacts pinch = ring_grasp(2, kFriction);
  TaskWrenches task;
  task.wrenches = {Wrench::Unit(2), 4.0 * Wrench::Unit(2)};
  expect_near(task_resistance(pinch, {}, task, exact(WrenchNorm::l1)), kFriction / 4.0);
  task.wrenches.push_back(Wrench::Unit(3));  // about the line through the fingers
  EXPECT_EQ(task_resistance(pinch, {}, task, exact(WrenchNorm::l1)).upper, 0.0);
}

// The unit ball is epsilon; axes of twice the length halve it.
TEST(TaskResistance, OfABallIsEpsilon) {
  Random random(12);
  const Contacts contacts = random_grasp(random, 6, 0.6);
  const WrenchSpaceOptions pyramid;
  const double value = grasp_epsilon(contacts, {}, pyramid).lower;
  ASSERT_GT(value, 0.0);
  TaskEllipsoid ball;
  expect_near(task_resistance(contacts, {}, ball, pyramid), value);
  ball.axes *= 2.0;
  expect_near(task_resistance(contacts, {}, ball, pyramid), value / 2.0);
}

// An ellipsoid is a polytope of many wrenches, seen from outside.
TEST(TaskResistance, OfAnEllipsoidIsBelowThatOfItsPoints) {
  Random random(13);
  const Contacts contacts = random_grasp(random, 6, 0.6);
  TaskEllipsoid ellipsoid;
  for (double& entry : ellipsoid.axes.reshaped()) entry += random.uniform(-0.4, 0.4);
  TaskWrenches points;
  for (int i = 0; i < 300; ++i) {
    Wrench u;
    for (double& entry : u) entry = random.uniform(-1.0, 1.0);
    points.wrenches.push_back(ellipsoid.axes * u.normalized());
  }
  const Interval whole = task_resistance(contacts, {}, ellipsoid);
  const Interval some = task_resistance(contacts, {}, points);
  EXPECT_GT(whole.lower, 0.0);
  EXPECT_LE(whole.lower, some.upper * (1.0 + 1e-9));
  EXPECT_GT(whole.upper, 0.3 * some.lower);
}

// A push at one finger is taken up by the other one; a push across, by friction.
TEST(ObjectWrenchRatio, OfPushesOnAPinch) {
  const Contacts pinch = ring_grasp(2, kFriction);
  Contacts pushes = pinch;
  for (Contact& push : pushes) push.friction = 0.0;
  expect_near(object_wrench_ratio(pinch, {}, pushes), 1.0);
  pushes.push_back({{0.0, 0.0, 0.0}, Eigen::Vector3d::UnitZ(), 0.0});
  expect_near(object_wrench_ratio(pinch, {}, pushes, exact(WrenchNorm::l1)), kFriction);
}

TEST(TaskResistance, RefusesWhatIsNoTask) {
  const Contacts pinch = ring_grasp(2, kFriction);
  EXPECT_THROW(task_resistance(pinch, {}, TaskWrenches{}), InputError);
  EXPECT_THROW(task_resistance(pinch, {}, TaskGravity{Eigen::Vector3d::Zero(), 1.0}), InputError);
  EXPECT_THROW(task_resistance(pinch, {}, TaskGravity{Eigen::Vector3d::UnitX(), -1.0}), InputError);
  TaskEllipsoid flat;
  flat.axes.col(2).setZero();
  EXPECT_THROW(task_resistance(pinch, {}, flat), InputError);
}

}  // namespace
}  // namespace prehend::test
