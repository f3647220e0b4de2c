#include "sim/motion/dynamic_grasp/form_dynamic_grasp.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

constexpr double kCube = 0.05;  // edge [m]

// A cube in the middle of the world, on a table or floating; the parallel jaw comes from above.
Scene cube_scene(bool on_table, double height = kCube) {
  Scene scene;
  scene.name = "cube";
  scene.object = make_graspable("cube", make_box({kCube, kCube, height}), Material::plastic, 0.2);
  scene.hand = find_robot("parallel_jaw");
  if (!on_table) return scene;
  StaticBody table{"table", make_box({0.6, 0.6, 0.02})};
  table.X_WB = translation({0.0, 0.0, -0.5 * height - 0.0101});
  scene.obstacles = {table};
  return scene;
}

// The jaw is open, its middle `aside` of the cube's along the closing axis.
DynamicGraspStart from_above(const CompiledScene& scene, double aside) {
  Matrix3 down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  return {pose_from(down, Vector3(aside, 0.0, 0.06)),
          scene.scene.hand.hand->preshapes.front().dofs,
          {}};
}

std::vector<ObjectEventKind> kinds(const DynamicGrasp& formation) {
  std::vector<ObjectEventKind> kinds;
  for (const ObjectEvent& event : formation.events) kinds.push_back(event.kind);
  return kinds;
}

TEST(FormGrasp, TheFirstPlateToArrivePushesTheCubeToTheMiddle) {
  const CompiledScene scene = compile(cube_scene(true));
  DynamicGraspOptions options;
  options.travel = 1e-3;
  for (const double aside : {-0.005, 0.0, 0.005}) {
    const DynamicGrasp formation =
        form_dynamic_grasp(scene, hand_model(scene), from_above(scene, aside), options);
    EXPECT_EQ(formation.end, ObjectEnd::held) << aside;
    // The plates press on each other without knowing where: the cube goes on by a little.
    EXPECT_NEAR(formation.X_WO.translation().x(), aside, 5e-4);
    EXPECT_NEAR(formation.X_WO.translation().z(), 0.0, 2e-4);
    EXPECT_EQ(kinds(formation), (std::vector{ObjectEventKind::touched, ObjectEventKind::gripped,
                                             ObjectEventKind::lifted}));
    EXPECT_EQ(formation.last, StepOutcome::moved);
  }
}

TEST(FormGrasp, EndsWhereTheObjectWouldGoTooFar) {
  const CompiledScene scene = compile(cube_scene(true));
  DynamicGraspStart start = from_above(scene, 0.005);
  const DynamicGrasp held = form_dynamic_grasp(scene, hand_model(scene), start, {});
  start.farthest = 0.006;
  const DynamicGrasp near = form_dynamic_grasp(scene, hand_model(scene), start, {});
  EXPECT_EQ(near.end, ObjectEnd::held);
  EXPECT_EQ(near.X_WO.matrix(), held.X_WO.matrix());
  start.farthest = 0.002;
  const DynamicGrasp far = form_dynamic_grasp(scene, hand_model(scene), start, {});
  EXPECT_EQ(far.end, ObjectEnd::pushed_away);
  EXPECT_LT(far.seconds, held.seconds);
  EXPECT_GT(far.X_WO.translation().x(), 0.002);
  EXPECT_LT(far.X_WO.translation().x(), 0.005);
}

// The palm pushes the cube off a little, and the plates need longer to come than an object may be
// out of touch before it counts as lost.
TEST(FormGrasp, WhatThePalmTouchesIsNotLostBeforeTheFingersCome) {
  Scene slow = cube_scene(false, 3.0 * kCube);
  for (DegreeOfFreedom& dof : slow.hand.dofs) dof.closing_velocity *= 0.2;
  const CompiledScene scene = compile(std::move(slow));
  const auto hand = hand_model(scene);
  DynamicGraspStart start = from_above(scene, 0.0);
  start.X_WH.translation().z() += 0.1;
  DynamicGraspOptions glance;
  glance.close = 1e-3;
  glance.lift = 0.0;
  for (const double by : {1e-3, 1e-5}) {
    const auto lowered = [&] {
      DynamicGraspStart lower = start;
      lower.X_WH.translation().z() -= by;
      return lower;
    };
    while (form_dynamic_grasp(scene, hand, lowered(), glance).last != StepOutcome::blocked) {
      start = lowered();
    }
  }
  const DynamicGrasp formation = form_dynamic_grasp(scene, hand, start, {});
  EXPECT_EQ(formation.end, ObjectEnd::held);
  ASSERT_FALSE(formation.events.empty());
  EXPECT_EQ(formation.events.front().kind, ObjectEventKind::touched);
  EXPECT_EQ(formation.events.front().link, "palm");
}

// Longer steps see the second plate later, by no more than they move in one.
TEST(FormGrasp, LongerStepsEndAtTheSamePlaces) {
  const CompiledScene scene = compile(cube_scene(true));
  for (const double aside : {-0.005, 0.003, 0.005}) {
    const DynamicGrasp formation =
        form_dynamic_grasp(scene, hand_model(scene), from_above(scene, aside), {});
    EXPECT_EQ(formation.end, ObjectEnd::held) << aside;
    EXPECT_NEAR(formation.X_WO.translation().x(), aside, 0.5 * DynamicGraspOptions{}.travel);
    EXPECT_LT(formation.steps, 100);
  }
}

// Without friction the plates slide up along the cube, which stays on the table.
TEST(FormGrasp, WithoutFrictionTheCubeStaysOnTheTable) {
  Scene slippery = cube_scene(true);
  slippery.friction.set(Material::rubber, Material::plastic, 0.0);
  const CompiledScene scene = compile(std::move(slippery));
  DynamicGraspOptions options;
  options.lift = 0.08;
  const DynamicGrasp formation =
      form_dynamic_grasp(scene, hand_model(scene), from_above(scene, 0.0), options);
  EXPECT_EQ(formation.end, ObjectEnd::squeezed_out);
  EXPECT_EQ(kinds(formation).back(), ObjectEventKind::left);
}

// Nothing carries what floats, so there is no weight, and no lift to see whether it is held.
TEST(FormGrasp, WhatFloatsHasNoWeight) {
  const CompiledScene scene = compile(cube_scene(false));
  const DynamicGrasp formation =
      form_dynamic_grasp(scene, hand_model(scene), from_above(scene, 0.003), {});
  EXPECT_EQ(formation.end, ObjectEnd::held);
  EXPECT_NEAR(formation.X_WO.translation().z(), 0.0, 1e-6);
  EXPECT_EQ(kinds(formation), (std::vector{ObjectEventKind::touched, ObjectEventKind::gripped}));
}

TEST(FormGrasp, AHandThatClosesBesideTheObjectDoesNotTouchIt) {
  const CompiledScene scene = compile(cube_scene(true));
  DynamicGraspStart start = from_above(scene, 0.0);
  start.X_WH.translation().y() = 0.2;
  const DynamicGrasp formation = form_dynamic_grasp(scene, hand_model(scene), start, {});
  EXPECT_EQ(formation.end, ObjectEnd::untouched);
  EXPECT_TRUE(formation.events.empty());
}

TEST(FormGrasp, TheSameStartGivesTheSameBytes) {
  const CompiledScene scene = compile(cube_scene(true));
  const DynamicGraspStart start = from_above(scene, 0.004);
  const DynamicGrasp once = form_dynamic_grasp(scene, hand_model(scene), start, {});
  const DynamicGrasp again = form_dynamic_grasp(scene, hand_model(scene), start, {});
  EXPECT_EQ(once.X_WO.matrix(), again.X_WO.matrix());
  EXPECT_EQ(once.joints, again.joints);
  EXPECT_EQ(once.steps, again.steps);
}

// Only what is near takes part, as long as the object stays there.
TEST(FormGrasp, WhatIsFarAwayChangesNothing) {
  const CompiledScene scene = compile(cube_scene(true));
  Scene crowded = cube_scene(true);
  for (int i = 0; i < 20; ++i) {
    StaticBody box{"box " + std::to_string(i), make_box({0.1, 0.1, 0.1})};
    box.X_WB = translation({2.0, 0.2 * i, 0.0});
    crowded.obstacles.push_back(box);
  }
  const CompiledScene more = compile(std::move(crowded));
  for (const double aside : {0.004, 0.02}) {
    const DynamicGraspStart start = from_above(scene, aside);
    const DynamicGrasp alone = form_dynamic_grasp(scene, hand_model(scene), start, {});
    const DynamicGrasp among = form_dynamic_grasp(more, hand_model(more), start, {});
    EXPECT_EQ(alone.X_WO.matrix(), among.X_WO.matrix());
    EXPECT_EQ(alone.joints, among.joints);
    EXPECT_EQ(alone.steps, among.steps);
    EXPECT_EQ(alone.end, among.end);
  }
}

// The floor is far below the cube, which nothing carries: it falls there and lies on it.
TEST(FormGrasp, WhatFallsLandsOnWhatWasFarAway) {
  Scene high = cube_scene(false);
  StaticBody floor{"floor", make_box({2.0, 2.0, 0.02})};
  floor.X_WB = translation({0.0, 0.0, -0.6});
  high.obstacles = {floor};
  const CompiledScene scene = compile(std::move(high));
  DynamicGraspOptions options;
  options.settle = 1.0;
  const DynamicGrasp formation =
      form_dynamic_grasp(scene, hand_model(scene), from_above(scene, 0.0), options);
  EXPECT_EQ(formation.end, ObjectEnd::untouched);
  EXPECT_NEAR(formation.X_WO.translation().z(), -0.6 + 0.01 + 0.5 * kCube, 1e-3);
}

TEST(FormGrasp, MovesNothingWhereBodiesOverlapAtTheStart) {
  const CompiledScene scene = compile(cube_scene(true));
  DynamicGraspStart start = from_above(scene, 0.0);
  start.X_WH.translation().z() = 0.01;
  const DynamicGrasp formation = form_dynamic_grasp(scene, hand_model(scene), start, {});
  EXPECT_EQ(formation.last, StepOutcome::blocked);
  EXPECT_EQ(formation.steps, 0);
  EXPECT_EQ(formation.end, ObjectEnd::untouched);
  EXPECT_EQ(formation.X_WH.matrix(), start.X_WH.matrix());
}

}  // namespace
}  // namespace prehend
