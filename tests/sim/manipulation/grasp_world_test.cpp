#include "sim/manipulation/grasp_world.h"

#include <string>

#include <gtest/gtest.h>

#include "sim/scene/compiled_scene.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/object_mass.h"
#include "sim/shape/basic_shapes.h"

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

World world_of_grasp(Scene scene, const TestProcedure& procedure) {
  const CompiledScene ready = compile(std::move(scene));
  GraspPosture posture;
  posture.X_OH = translation({0.0, 0.0, 1.0});
  posture.dofs = initial_dofs(ready.scene.hand);
  return make_grasp_world(ready, hand_model(ready), posture, procedure).world;
}

TEST(GraspWorld, TakesKineticFrictionAndRestitutionFromTheScene) {
  Scene scene = cube_on_table();
  scene.object.restitution = 0.7;
  scene.obstacles[0].restitution = 0.2;
  scene.friction.set(Material::plastic, Material::wood, 0.5);
  scene.kinetic_friction.set(Material::plastic, Material::wood, 0.3);
  TestProcedure procedure;
  procedure.on_support = true;
  const World world = world_of_grasp(scene, procedure);
  ASSERT_EQ(world.bodies.size(), 2U);
  EXPECT_EQ(world.bodies[kObjectBody].restitution, 0.7);
  EXPECT_EQ(world.bodies[1].restitution, 0.2);
  ASSERT_TRUE(world.laws.kinetic);
  EXPECT_EQ(world.laws.friction.between(Material::wood, Material::plastic), 0.5);
  EXPECT_EQ(world.laws.kinetic->between(Material::wood, Material::plastic), 0.3);
  EXPECT_EQ(world.laws.kinetic->between(Material::wood, Material::glass),
            scene.friction.between(Material::wood, Material::glass));
}

// Where the scene says the mass is, it is in what moves; a protocol changes how much there is.
TEST(GraspWorld, TakesTheMassFromWhereTheSceneHasIt) {
  Scene scene = cube_on_table();
  const MassPart bottom{.where = BeyondPlane{{0, 0, 0}, {0, 0, -1}}, .density = 3000.0};
  state_mass(scene.object, {.density = 1000.0, .parts = {bottom}});
  const GraspableBody object = scene.object;
  EXPECT_NEAR(object.center_of_mass.z(), -0.005, 1e-12);
  TestProcedure procedure;
  const auto inertial = [&] {
    return world_of_grasp(scene, procedure).bodies[kObjectBody].inertial;
  };
  EXPECT_EQ(inertial().mass, object.mass);
  EXPECT_EQ(inertial().center_of_mass, object.center_of_mass);
  EXPECT_EQ(inertial().inertia, object.inertia);
  procedure.object.mass = 2.0 * object.mass;
  EXPECT_EQ(inertial().center_of_mass, object.center_of_mass);
  EXPECT_LT((inertial().inertia - 2.0 * object.inertia).norm(), 1e-12 * object.inertia.norm());
  state_center_of_mass(scene.object, {0.01, 0.0, 0.0});
  EXPECT_EQ(inertial().center_of_mass, Vector3(0.01, 0.0, 0.0));
}

TEST(GraspWorld, SlidesAsItSticksWhereTheSceneSaysNothing) {
  EXPECT_FALSE(world_of_grasp(cube_on_table(), {}).laws.kinetic);
}

TEST(GraspWorld, TheFrictionOfAProtocolHoldsForWhatSlidesAsWell) {
  Scene scene = cube_on_table();
  const Material pad = material_named(scene.hand.links.back().material);
  scene.kinetic_friction.set(pad, Material::plastic, 0.1);
  TestProcedure procedure;
  procedure.friction = 0.8;
  const World world = world_of_grasp(scene, procedure);
  ASSERT_TRUE(world.laws.kinetic);
  EXPECT_EQ(world.laws.kinetic->between(pad, Material::plastic), 0.8);
}

TEST(GraspWorld, PartsOfSurfacesAreThoseOfTheScene) {
  Scene scene = cube_on_table();
  SurfaceRegion upper;
  upper.beyond = BeyondPlane{Vector3::Zero(), Vector3::UnitZ()};
  scene.object.surfaces = {{upper, {Material::glass}}};
  scene.obstacles[0].surfaces = {{upper, {Material::metal}}};
  const std::string link = scene.hand.links.back().name;
  scene.link_surfaces = {{link, {{upper, {Material::rubber}}}}};
  TestProcedure procedure;
  procedure.on_support = true;
  const World world = world_of_grasp(scene, procedure);
  const Vector3 top(0.0, 0.0, 0.02);
  const SurfaceMaterials& object = world.bodies[kObjectBody].surface;
  EXPECT_EQ(object.at(top).material, Material::glass);
  EXPECT_EQ(object.at(-top).material, Material::plastic);
  EXPECT_EQ(world.bodies[1].surface.at({0.0, 0.0, 0.01}).material, Material::metal);
  const RobotModel& model = *world.robots[0].model;
  ASSERT_EQ(model.surfaces.size(), model.robot.links.size());
  for (std::size_t l = 0; l < model.surfaces.size(); ++l) {
    EXPECT_EQ(model.surfaces[l].uniform(), model.robot.links[l].name != link);
  }
  // A protocol's friction is between the hand and all of the object.
  procedure.friction = 0.8;
  const World rough = world_of_grasp(scene, procedure);
  for (const Vector3& p : {top, Vector3(-top)}) {
    for (const Material of_hand : model.materials) {
      EXPECT_EQ(
          friction_between(rough.laws.friction, rough.bodies[kObjectBody].surface.at(p), {of_hand}),
          0.8);
    }
  }
}

}  // namespace
}  // namespace prehend
