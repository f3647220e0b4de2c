#include "sim/manipulation/grasp_world.h"

#include <gtest/gtest.h>

#include "sim/geometry/basic_shapes.h"
#include "sim/scene/make_scene.h"

namespace prehend {
namespace {

// A cube on a table below the library's parallel jaw.
Scene cube_on_table() {
  Scene scene =
      make_scene(make_graspable("cube", make_box(Vector3::Constant(0.04)), Material::plastic, 0.1),
                 "parallel_jaw");
  add_obstacle(scene, "table", make_box({0.5, 0.5, 0.02}), translation({0.0, 0.0, -0.0301}));
  return scene;
}

World world_of_grasp(Scene scene, const Protocol& protocol) {
  const CompiledScene ready = compile(std::move(scene));
  GraspPosture posture;
  posture.X_OH = translation({0.0, 0.0, 1.0});
  posture.dofs = initial_dofs(ready.scene.hand);
  return make_grasp_world(ready, hand_model(ready), posture, protocol).world;
}

TEST(GraspWorld, TakesKineticFrictionAndRestitutionFromTheScene) {
  Scene scene = cube_on_table();
  scene.object.restitution = 0.7;
  scene.obstacles[0].restitution = 0.2;
  scene.friction.set(Material::plastic, Material::wood, 0.5);
  scene.kinetic_friction.set(Material::plastic, Material::wood, 0.3);
  Protocol protocol;
  protocol.on_support = true;
  const World world = world_of_grasp(scene, protocol);
  ASSERT_EQ(world.bodies.size(), 2U);
  EXPECT_EQ(world.bodies[kObjectBody].restitution, 0.7);
  EXPECT_EQ(world.bodies[1].restitution, 0.2);
  ASSERT_TRUE(world.laws.kinetic);
  EXPECT_EQ(world.laws.friction.between(Material::wood, Material::plastic), 0.5);
  EXPECT_EQ(world.laws.kinetic->between(Material::wood, Material::plastic), 0.3);
  EXPECT_EQ(world.laws.kinetic->between(Material::wood, Material::glass),
            scene.friction.between(Material::wood, Material::glass));
}

TEST(GraspWorld, SlidesAsItSticksWhereTheSceneSaysNothing) {
  EXPECT_FALSE(world_of_grasp(cube_on_table(), {}).laws.kinetic);
}

TEST(GraspWorld, TheFrictionOfAProtocolHoldsForWhatSlidesAsWell) {
  Scene scene = cube_on_table();
  const Material pad = material_named(scene.hand.links.back().material);
  scene.kinetic_friction.set(pad, Material::plastic, 0.1);
  Protocol protocol;
  protocol.friction = 0.8;
  const World world = world_of_grasp(scene, protocol);
  ASSERT_TRUE(world.laws.kinetic);
  EXPECT_EQ(world.laws.kinetic->between(pad, Material::plastic), 0.8);
}

}  // namespace
}  // namespace prehend
