#include "sim/robot/hand/test_bodies.h"

#include <set>

#include <gtest/gtest.h>

#include "sim/robot/files/robot_file.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// A jaw of the library that closes on bodies.
struct Jaw {
  Robot robot = find_robot("parallel_jaw");
  HandParts parts = find_hand_parts(robot);
  ClosingDofs closing = find_closing_dofs(robot, parts);
  SelfCollision collision{robot};
  TestClosing test{robot, parts, closing, collision};
  HandAxes axes{robot.hand->approach, robot.hand->closing, robot.hand->origin};
  const Preshape& open = robot.hand->preshapes.front();

  double hold(const Pose& X_BS) const {
    const ProximityMesh box(make_box({0.04, 0.03, 0.03}));
    return test.hold(box, X_BS, open.dofs, 0);
  }
};

TEST(TestClosing, HoldsABoxBetweenThePlatesOnly) {
  const Jaw jaw;
  EXPECT_GT(jaw.hold(translation({0.0, 0.0, jaw.open.depth})), 0.1);
  // The plates stop each at its side of a box that is not in the middle.
  EXPECT_GT(jaw.hold(translation({0.01, 0.0, jaw.open.depth})), 0.1);
  EXPECT_EQ(jaw.hold(translation({0.0, 0.0, 0.5})), 0.0);
  EXPECT_EQ(jaw.hold(translation({0.04, 0.0, jaw.open.depth})), 0.0) << "a plate begins inside";
}

// It may come nearer until the palm touches it, whose front is at the origin.
TEST(TestClosing, ComesAsNearAsThePalmLets) {
  const Jaw jaw;
  const ProximityMesh box(make_box({0.04, 0.03, 0.03}));
  const Pose X_BS = translation({0.0, 0.0, 0.2});
  EXPECT_NEAR(jaw.test.way_in(box, X_BS, Vector3::UnitZ(), 0.3, jaw.open.dofs), 0.185, 2e-4);
  EXPECT_LT(
      jaw.test.way_in(box, translation({0.0, 0.0, 0.01}), Vector3::UnitZ(), 0.3, jaw.open.dofs),
      0.0);
}

TEST(TestBodies, OfAJawAreHeldIfTheyFit) {
  const Jaw jaw;
  const std::vector<double> sizes = {0.02, 0.064, 0.09};
  const TestHolds holds = try_bodies(jaw.test, jaw.axes, 0, jaw.open, sizes);
  ASSERT_EQ(holds.bodies.size(), 9U);
  std::set<double> widths;
  for (const TestHolds::Held& held : holds.bodies) {
    if (held.body == "box") EXPECT_EQ(held.epsilon > 0.0, held.width < 0.08) << held.width;
    EXPECT_FALSE(held.width > 0.08 && held.epsilon > 0.0) << held.body;
    if (held.epsilon > 0.0) widths.insert(held.width);
  }
  EXPECT_EQ(widths, (std::set<double>{0.02, 0.064}));
}

}  // namespace
}  // namespace prehend
