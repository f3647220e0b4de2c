// Strategies by which hands close.
#include "sim/motion/dynamic_grasp/closing.h"

#include <gtest/gtest.h>

#include "sim/motion/dynamic_grasp/form_dynamic_grasp.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

constexpr double kStep = 0.01;  // s

// A thumb, two fingers and a spread that does not close.
Robot four_dofs() {
  Robot hand;
  for (const double velocity : {1.0, -1.0, 1.0, 0.0}) {
    hand.dofs.push_back({.name = "", .closing_velocity = velocity});
  }
  return hand;
}

std::vector<double> efforts(const Closing& closing) {
  std::vector<double> efforts;
  for (std::size_t d = 0; d < 4; ++d) efforts.push_back(closing.effort(d));
  return efforts;
}

using Parts = std::vector<double>;
const std::vector<double> kMoving = {1.0, -1.0, 1.0, 0.0};

TEST(Closing, IsAllAtOnceWithoutAStrategy) {
  const Closing closing(four_dofs());
  EXPECT_TRUE(closing.is_full());
  EXPECT_EQ(efforts(closing), (Parts{1.0, 1.0, 1.0, 0.0}));
}

TEST(Closing, IsGentleUntilEverythingTouchesOrStops) {
  Closing closing(four_dofs(), {.name = "gentle", .effort = 0.2});
  EXPECT_EQ(efforts(closing), (Parts{0.2, 0.2, 0.2, 0.0}));
  closing.look({{true, true, false, false}, kMoving}, kStep);
  EXPECT_EQ(efforts(closing), (Parts{0.2, 0.2, 0.2, 0.0}));
  // The last one is at its limit. What touched once counts although it moves on.
  for (int k = 0; k < 4; ++k) closing.look({{false, false, false, false}, {1, -1, 0, 0}}, kStep);
  EXPECT_FALSE(closing.is_full());
  closing.look({{false, false, false, false}, {1, -1, 0, 0}}, kStep);
  EXPECT_TRUE(closing.is_full());
  EXPECT_EQ(efforts(closing), (Parts{1.0, 1.0, 1.0, 0.0}));
}

TEST(Closing, BeginsWithWhatIsFirstWhichWaitsForTheOthers) {
  Closing closing(four_dofs(), {.name = "thumb_first", .first = {0}, .waits = true});
  EXPECT_EQ(efforts(closing), (Parts{1.0, 0.0, 0.0, 0.0}));
  closing.look({{false, false, false, false}, kMoving}, kStep);
  EXPECT_EQ(efforts(closing), (Parts{1.0, 0.0, 0.0, 0.0}));
  closing.look({{true, false, false, false}, kMoving}, kStep);
  EXPECT_EQ(efforts(closing), (Parts{0.0, 1.0, 1.0, 0.0}));
  closing.look({{true, true, false, false}, kMoving}, kStep);
  EXPECT_EQ(efforts(closing), (Parts{0.0, 0.0, 1.0, 0.0}));
  closing.look({{true, true, true, false}, kMoving}, kStep);
  EXPECT_EQ(efforts(closing), (Parts{1.0, 1.0, 1.0, 0.0}));
}

TEST(Closing, DoesNotFollowWhatRollsAwayForEver) {
  Closing closing(four_dofs(), {.name = "waiting", .waits = true});
  double time = 0.0;
  for (; !closing.is_full() && time < 10.0; time += kStep) {
    closing.look({{time > 3.0, false, false, false}, kMoving}, kStep);
  }
  EXPECT_NEAR(time, 4.0, 2.0 * kStep);
}

// A cube on a table, nearer to the thumb of a Barrett hand above it: the thumb pushes it to the
// fingers. A thumb that waits does not. One that presses by less than the friction of a heavy cube
// does not either: 0.9 N m at 50 mm and more are at most 18 N, and 0.3 of 10 kg is 29 N.
TEST(Closing, APatientOrGentleThumbDoesNotPushACubeAway) {
  constexpr double kEdge = 0.05;
  Scene cube;
  cube.name = "cube";
  cube.object = make_graspable("cube", make_box({kEdge, kEdge, 3.0 * kEdge}), Material::wood, 10.0);
  cube.hand = find_robot("barrett");
  StaticBody table{"table", make_box({0.6, 0.6, 0.02})};
  table.material = Material::wood;
  table.X_WB = translation({0.0, 0.0, -1.5 * kEdge - 0.0101});
  cube.obstacles = {table};
  const CompiledScene scene = compile(std::move(cube));
  Matrix3 down;
  down << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  DynamicGraspStart start{
      pose_from(down, Vector3(0.0, 0.02, 0.13)), scene.scene.hand.hand->preshapes.front().dofs, {}};
  DynamicGraspOptions until_closed;
  until_closed.lift = 0.0;
  const auto pushed = [&](const ClosingStrategy& closing, double seconds) {
    start.strategy = closing;
    until_closed.close = seconds / (1.0 + Closing(scene.scene.hand, closing).stages());
    const DynamicGrasp grasp = form_dynamic_grasp(scene, hand_model(scene), start, until_closed);
    return grasp.X_WO.translation().norm();
  };
  // Before all of them press.
  constexpr double kSeconds = 1.4;
  EXPECT_GT(pushed({}, kSeconds), 1e-2);
  // By no more than in the step in which it touches.
  EXPECT_LT(pushed({.name = "patient", .waits = true}, kSeconds), 2e-3);
  EXPECT_LT(pushed({.name = "gentle", .effort = 0.18}, kSeconds), 1e-4);
}

}  // namespace
}  // namespace prehend
