// What stands or is held for a long time, without sleeping.
#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/motion/world.h"
#include "tests/support/sample_worlds.h"

namespace prehend {
namespace {

StepOptions awake() {
  StepOptions options;
  options.sleep_after = std::numeric_limits<double>::infinity();
  return options;
}

// Twenty boxes, each a little off the one below.
TEST(Standing, ATowerOfTwentyBoxesDoesNotMove) {
  std::vector<WorldBody> bodies = {test::ground()};
  for (int i = 0; i < 20; ++i) {
    bodies.push_back(test::box("box" + std::to_string(i), Vector3::Constant(0.1), 1.0,
                               {0.003 * (i % 2), 0.0, 0.05 + 0.10005 * (i + 1) - 0.1}));
  }
  World world = test::world_with(std::move(bodies), 0.5);
  const World start = world;
  ASSERT_EQ(test::run(world, 60.0, awake()), StepOutcome::moved);
  double most = 0.0;
  for (std::size_t i = 1; i < world.bodies.size(); ++i) {
    most = std::max(most, (world.bodies[i].motion.X_WB.translation() -
                           start.bodies[i].motion.X_WB.translation())
                              .norm());
  }
  EXPECT_LT(most, 1e-4);
  RecordProperty("moved_um", std::to_string(1e6 * most));
}

// 0.1 kg between two plates that are pressed on it with 10 N each, friction 0.5: a tenth of what
// friction bears.
TEST(Standing, APinchedBoxDoesNotCreep) {
  std::vector<WorldBody> bodies = {
      test::box("object", {0.04, 0.04, 0.04}, 0.1, Vector3::Zero()),
      test::box("left", {0.01, 0.03, 0.03}, 0.1, {-0.02505, 0.0, 0.0}),
      test::box("right", {0.01, 0.03, 0.03}, 0.1, {0.02505, 0.0, 0.0})};
  // The plate on the left is held, the other is pressed on by a force that also bears its weight.
  bodies[1].is_fixed = true;
  bodies[2].force_W = {-10.0, 0.0, 0.1 * test::kG};
  World world = test::world_with(std::move(bodies), 0.5);
  ASSERT_EQ(test::run(world, 1.0, awake()), StepOutcome::moved);
  const Pose before = world.bodies[0].motion.X_WB;
  ASSERT_EQ(test::run(world, 100.0, awake()), StepOutcome::moved);
  const double crept =
      (world.bodies[0].motion.X_WB.translation() - before.translation()).norm() / 100.0;
  EXPECT_LT(crept, 0.05e-6);
  RecordProperty("creep_um_per_s", std::to_string(1e6 * crept));
  for (const WorldContact& contact : world.contacts) EXPECT_GT(contact.gap, 0.0);
  for (int plate = 1; plate <= 2; ++plate) {
    const WorldBody& other = world.bodies[static_cast<std::size_t>(plate)];
    EXPECT_FALSE(bodies_overlap(world.bodies[0].shape, other.shape,
                                world.bodies[0].motion.X_WB.inverse() * other.motion.X_WB));
  }
}

}  // namespace
}  // namespace prehend
