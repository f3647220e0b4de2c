#include "sim/robot/hand/closing_signs.h"

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "sim/shape/basic_shapes.h"
#include "tests/sim/robot/hand/made_hand.h"

namespace prehend {
namespace {

// Each finger closes over the long part of its range, whatever its joints' axes and frames are.
TEST(ClosingSigns, DoNotDependOnHowJointsAreWritten) {
  constexpr int kHands = 200;
  Random random(3);
  for (int hand = 0; hand < kHands; ++hand) {
    std::vector<MadeFinger> fingers = random_fingers(random);
    for (MadeFinger& finger : fingers) finger.abducts = hand % 2 == 1;
    const std::vector<Writing> writings =
        with_random_starts(random, random_writings(random, joint_count(fingers)));
    const Robot robot = made_hand(fingers, writings);
    const std::vector<int> signs = find_closing_signs(robot, find_hand_parts(robot));
    for (std::size_t d = 0; d < signs.size(); ++d) {
      const bool sideways = robot.dofs[d].name.ends_with("_side");
      const int expected = sideways ? 0 : writings[d].flipped ? -1 : 1;
      EXPECT_EQ(signs[d], expected) << hand << " " << robot.dofs[d].name;
    }
  }
}

// Two jaws that turn without end: the ranges say nothing, the tips do.
TEST(ClosingSigns, OfJointsWithoutEndBringTheTipsTogether) {
  Robot robot{.name = "made"};
  robot.links.push_back(
      {.name = "palm", .material = "plastic", .mesh = make_box({0.1, 0.04, 0.03})});
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0.0 ? "left" : "right";
    const int joint = static_cast<int>(robot.joints.size());
    robot.joints.push_back({.name = name,
                            .X_PJ = translation({0.04 * side, 0.0, 0.02}),
                            .axis = Vector3::UnitY(),
                            .lower = -6.28,
                            .upper = 6.28,
                            .dof = joint,
                            .chain = joint});
    robot.dofs.push_back({.name = name, .lower = -6.28, .upper = 6.28});
    robot.links.push_back(
        {.name = name,
         .material = "plastic",
         .joint = joint,
         .mesh = transformed(make_box({0.01, 0.02, 0.08}), translation({0.0, 0.0, 0.045}))});
    robot.chains.push_back({.name = name, .first_joint = joint, .joint_count = 1});
  }
  EXPECT_EQ(find_closing_signs(robot, find_hand_parts(robot)), (std::vector<int>{1, -1}));
}

}  // namespace
}  // namespace prehend
