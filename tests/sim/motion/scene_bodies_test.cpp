#include "sim/motion/scene_bodies.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/motion/require_world.h"
#include "sim/motion/step_world.h"
#include "sim/scene/scene.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

Scene tilted_scene(double slope) {
  Scene scene;
  scene.object = make_graspable("cube", make_box(Vector3::Constant(0.04)), Material::plastic, 0.1);
  const Pose X_WT(Eigen::AngleAxisd(slope, Vector3::UnitY()));
  scene.object.X_WO = X_WT * translation({0.0, 0.0, 0.02005});
  scene.obstacles = {
      {"board", make_box({2.0, 2.0, 0.02}), X_WT * translation({0.0, 0.0, -0.01}), Material::wood}};
  return scene;
}

// On a slope between the angles of kinetic and static friction, what lies keeps lying and what
// slides goes on sliding, by g (sin a - mu cos a).
TEST(SceneWorld, WhatSlidesHasTheKineticFrictionOfTheScene) {
  const double slope = 0.3;  // tan: 0.31
  Scene scene = tilted_scene(slope);
  scene.friction.set(Material::plastic, Material::wood, 0.4);
  scene.kinetic_friction.set(Material::plastic, Material::wood, 0.2);
  const Vector3 down(std::cos(slope), 0.0, -std::sin(slope));
  for (const double speed : {0.0, 0.1}) {
    World world;
    add_bodies(scene, world);
    require_world(world);
    world.bodies[0].motion.linear = speed * down;
    const double seconds = 0.3;
    for (double time = 0.0; time < seconds - 1e-9;) {
      const StepResult result = step_world(world, {.step = 1e-3});
      ASSERT_EQ(result.outcome, StepOutcome::moved);
      time += result.time;
    }
    const double reached = world.bodies[0].motion.linear.dot(down);
    const double rate = 9.81 * (std::sin(slope) - 0.2 * std::cos(slope));
    // The first step does not know yet that it slides.
    EXPECT_NEAR(reached, speed > 0.0 ? speed + rate * seconds : 0.0, 0.01) << speed;
  }
}

// On a board whose one half is slippery, a cube stays on the other half and slides there, by
// g (sin a - mu cos a); so does a cube whose underside is slippery.
TEST(SceneWorld, APartOfASurfaceHasItsOwnFriction) {
  const double slope = 0.3;
  const Vector3 down(std::cos(slope), 0.0, -std::sin(slope));
  SurfaceMaterial wet{Material::wood, "wet"};
  wet.friction[Material::plastic] = 0.1;
  SurfaceRegion half;
  half.beyond = BeyondPlane{Vector3::Zero(), Vector3::UnitY()};
  SurfaceRegion under;
  under.beyond = BeyondPlane{{0.0, 0.0, -0.01}, -Vector3::UnitZ()};
  SurfaceMaterial slick{Material::plastic, "slick"};
  slick.friction[Material::wood] = 0.1;
  for (const bool of_board : {true, false}) {
    for (const bool slides : {false, true}) {
      Scene scene = tilted_scene(slope);
      if (of_board) {
        scene.obstacles[0].surfaces = {{half, wet}};
        scene.object.X_WO = translation({0.0, slides ? 0.2 : -0.2, 0.0}) * scene.object.X_WO;
      } else {
        // Turned over, another side of it lies on the board.
        scene.object.surfaces = {{under, slick}};
        if (!slides)
          scene.object.X_WO.rotate(Eigen::AngleAxisd(std::numbers::pi, Vector3::UnitX()));
      }
      World world;
      add_bodies(scene, world);
      const double seconds = 0.3;
      for (double time = 0.0; time < seconds - 1e-9;) {
        const StepResult result = step_world(world, {.step = 1e-3});
        ASSERT_EQ(result.outcome, StepOutcome::moved);
        time += result.time;
      }
      const double rate = 9.81 * (std::sin(slope) - 0.1 * std::cos(slope));
      EXPECT_NEAR(world.bodies[0].motion.linear.dot(down), slides ? rate * seconds : 0.0, 0.01);
    }
  }
}

TEST(SceneWorld, TheObjectMovesAndObstaclesDoNot) {
  Scene scene = tilted_scene(0.0);
  scene.obstacles[0].restitution = 0.5;
  World world;
  add_bodies(scene, world);
  ASSERT_EQ(world.bodies.size(), 2U);
  EXPECT_FALSE(world.bodies[0].is_fixed);
  EXPECT_EQ(world.bodies[0].inertial.mass, 0.1);
  EXPECT_TRUE(world.bodies[1].is_fixed);
  EXPECT_EQ(world.bodies[1].restitution, 0.5);
  EXPECT_FALSE(world.laws.kinetic);
  scene.object.mass = 0.0;
  EXPECT_THROW(add_bodies(scene, world), InputError);
}

}  // namespace
}  // namespace prehend
