#include "sim/motion/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "sim/motion/require_world.h"
#include "tests/support/refusal_of.h"
#include "tests/support/sample_worlds.h"

namespace prehend {
namespace {

using test::body_of;
using test::box;
using test::ground;
using test::kG;
using test::run;
using test::world_with;

// At any step: a parabola is of second order.
TEST(World, FreeFallIsExact) {
  for (const double step : {1e-2, 2.5e-3}) {
    World world = world_with({box("box", {0.1, 0.1, 0.1}, 1.0, {0.0, 0.0, 10.0})}, 0.5);
    world.bodies[0].motion.linear = {1.0, 0.0, 2.0};
    ASSERT_EQ(run(world, 1.0, {.step = step}), StepOutcome::moved);
    EXPECT_NEAR(world.bodies[0].motion.linear.z(), 2.0 - kG, 1e-12);
    const Vector3 exact(1.0, 0.0, 10.0 + 2.0 - 0.5 * kG);
    EXPECT_LT((world.bodies[0].motion.X_WB.translation() - exact).norm(), 1e-11);
  }
}

TEST(World, ABoxComesToRestOnThePlate) {
  World world = world_with({ground(), box("box", {0.1, 0.1, 0.1}, 1.0, {0.0, 0.0, 0.2})}, 0.5);
  ASSERT_EQ(run(world, 1.0), StepOutcome::moved);
  const RigidMotion& motion = world.bodies[1].motion;
  EXPECT_NEAR(motion.X_WB.translation().z(), 0.05 + 5e-5, 5e-5);
  EXPECT_LT(motion.linear.norm(), 1e-9);
  EXPECT_LT(motion.angular.norm(), 1e-9);
}

TEST(World, ASlidingBoxStopsWhereItShould) {
  World world = world_with({ground(), box("box", {0.1, 0.1, 0.04}, 1.0, {-1.0, 0.0, 0.0201})}, 0.3);
  world.bodies[1].motion.linear = {1.5, 0.0, 0.0};
  ASSERT_EQ(run(world, 1.0, {.step = 2.5e-4}), StepOutcome::moved);
  const double way = world.bodies[1].motion.X_WB.translation().x() + 1.0;
  EXPECT_NEAR(way, 1.5 * 1.5 / (2.0 * 0.3 * kG), 1e-3 * way);
  EXPECT_LT(world.bodies[1].motion.linear.norm(), 1e-9);
}

// Gravity tilted by the angle stands for the slope.
TEST(World, ABoxHoldsBelowTheAngleOfFrictionAndSlidesAboveIt) {
  const double friction = 0.4;
  for (const double off : {-0.1, 0.1}) {
    World world =
        world_with({ground(), box("box", {0.1, 0.1, 0.04}, 1.0, {0.0, 0.0, 0.0201})}, friction);
    ASSERT_EQ(run(world, 0.1), StepOutcome::moved);
    const double angle = std::atan(friction) + off * std::acos(-1.0) / 180.0;
    world.gravity = kG * Vector3(std::sin(angle), 0.0, -std::cos(angle));
    const double start = world.bodies[1].motion.X_WB.translation().x();
    ASSERT_EQ(run(world, 0.5), StepOutcome::moved);
    const double way = world.bodies[1].motion.X_WB.translation().x() - start;
    const double expected =
        off < 0.0 ? 0.0 : 0.5 * kG * (std::sin(angle) - friction * std::cos(angle)) * 0.25;
    EXPECT_NEAR(way, expected, 0.02 * expected + 1e-9) << off;
  }
}

TEST(World, NothingPenetratesAtAnySpeed) {
  World world =
      world_with({ground(), box("bullet", {0.01, 0.01, 0.01}, 0.01, {0.0, 0.0, 3.0})}, 0.5);
  world.bodies[1].motion.linear = {3.0, 0.0, -300.0};
  world.bodies[1].motion.angular = {200.0, 50.0, 10.0};
  double time = 0.0;
  while (time < 0.2) {
    const StepResult result = step_world(world);
    ASSERT_EQ(result.outcome, StepOutcome::moved) << time;
    time += result.time;
    const Pose X_AB = world.bodies[0].motion.X_WB.inverse() * world.bodies[1].motion.X_WB;
    ASSERT_FALSE(bodies_overlap(world.bodies[0].shape, world.bodies[1].shape, X_AB)) << time;
  }
}

TEST(World, ABouncingBallLosesByRestitution) {
  World world =
      world_with({ground(), body_of("ball", make_sphere(0.05, 3), 1.0, {0.0, 0.0, 0.5})}, 0.5);
  world.bodies[1].restitution = 0.8;
  double highest = 0.0;
  bool bounced = false;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(step_world(world, {.step = 5e-4}).outcome, StepOutcome::moved);
    if (world.bodies[1].motion.linear.z() > 0.0) bounced = true;
    if (bounced) highest = std::max(highest, world.bodies[1].motion.X_WB.translation().z());
    if (bounced && world.bodies[1].motion.linear.z() < -0.5) break;
  }
  EXPECT_NEAR(highest - 0.05, 0.64 * 0.45, 0.01);
}

TEST(World, ATowerStands) {
  std::vector<WorldBody> bodies = {ground()};
  for (int i = 0; i < 8; ++i) {
    bodies.push_back(box("box" + std::to_string(i), {0.1, 0.1, 0.1}, 1.0,
                         {0.003 * (i % 2), 0.0, 0.05 + 0.1001 * i + 5e-5}));
  }
  World world = world_with(std::move(bodies), 0.5);
  ASSERT_EQ(run(world, 0.2), StepOutcome::moved);
  const World settled = world;
  ASSERT_EQ(run(world, 1.0), StepOutcome::moved);
  for (std::size_t i = 1; i < world.bodies.size(); ++i) {
    const Vector3 moved =
        world.bodies[i].motion.X_WB.translation() - settled.bodies[i].motion.X_WB.translation();
    EXPECT_LT(moved.norm(), 1e-5) << i;
  }
}

TEST(World, WhatCannotBeSteppedIsRefused) {
  World world = world_with({ground(), box("box", {0.1, 0.1, 0.1}, 1.0, {0.0, 0.0, 0.02})}, 0.5);
  EXPECT_EQ(std::string(test::refusal_of([&] { require_world(world); }).what()),
            "ground: overlaps box at the start");
  world.bodies[1].motion.X_WB = translation({0.0, 0.0, 0.2});
  require_world(world);
  world.bodies[1].inertial.mass = -1.0;
  EXPECT_EQ(test::refusal_of([&] { require_world(world); }).field(), "box");
  for (const double step : {10.0, 0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(test::refusal_of([&] { require_world(world, {.step = step}); }).field(), "step");
  }
  const WorldBody good = box("box", {0.1, 0.1, 0.1}, 1.0, {0.0, 0.0, 0.2});
  const auto refuses = [&](const auto& change) {
    world.bodies[1] = good;
    require_world(world);
    change(world.bodies[1]);
    EXPECT_EQ(test::refusal_of([&] { require_world(world); }).field(), "box");
  };
  refuses([](WorldBody& body) { body.inertial.mass = 0.0; });
  refuses([](WorldBody& body) { body.inertial.mass = std::numeric_limits<double>::infinity(); });
  // No body has a moment larger than the sum of the other two, nor is one without extent turned.
  refuses([](WorldBody& body) { body.inertial.inertia = Vector3(1.0, 1.0, 3.0).asDiagonal(); });
  refuses([](WorldBody& body) { body.inertial.inertia = Vector3(1.0, 1.0, 0.0).asDiagonal(); });
  refuses([](WorldBody& body) { body.restitution = 1.5; });
  refuses([](WorldBody& body) { body.motion.linear.x() = std::nan(""); });
}

}  // namespace
}  // namespace prehend
