#include "sim/robot/files/loop_closure.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "tests/sim/robot/files/foreign_files.h"

namespace prehend {
namespace {

using test::has_note;
using test::read_text;

// A crank and a rocker of the same length, 40 mm apart, carry a coupler: a parallelogram. The
// coupler hangs on the crank; `anchor` is the point of it that stays on the rocker's end.
std::string parallelogram(const std::string& anchor) {
  return "<mujoco model=\"made\"><worldbody><body name=\"palm\"><geom size=\"0.01\"/>"
         "<body name=\"crank\"><joint name=\"crank\" axis=\"0 1 0\" range=\"0 60\"/>"
         "<geom size=\"0.01\"/><body name=\"coupler\" pos=\"0 0 0.05\"><joint name=\"coupler\" "
         "axis=\"0 1 0\" range=\"-90 90\"/><geom size=\"0.01\"/></body></body>"
         "<body name=\"rocker\" pos=\"0.04 0 0\"><joint name=\"rocker\" axis=\"0 1 0\" "
         "range=\"-90 90\"/><geom size=\"0.01\"/></body></body></worldbody>"
         "<equality><connect body1=\"coupler\" body2=\"rocker\" anchor=\"" +
         anchor +
         "\"/></equality><actuator><motor joint=\"crank\" "
         "forcerange=\"-1 1\"/></actuator></mujoco>";
}

TEST(LoopClosure, OfAParallelogramKeepsTheCouplerParallel) {
  const Robot robot = read_text(parallelogram("0.04 0 0")).robots.at(0).robot;
  ASSERT_EQ(robot.dofs.size(), 1U);
  EXPECT_EQ(robot.dofs[0].name, "crank");
  for (const Joint& joint : robot.joints) {
    const double expected = joint.name == "coupler" ? -1.0 : 1.0;
    EXPECT_NEAR(joint.ratio, expected, 1e-4) << joint.name;
    EXPECT_NEAR(joint.offset, 0.0, 1e-4) << joint.name;
  }
  EXPECT_TRUE(has_note(robot, "joint rocker follows crank in a closed loop"));
}

// Nearly a parallelogram: its followers are not linear, but the points still meet to a millimetre.
TEST(LoopClosure, FollowersMeetOverTheWholeRange) {
  const Robot robot = read_text(parallelogram("0.039 0 0.001")).robots.at(0).robot;
  ASSERT_EQ(robot.dofs.size(), 1U);
  std::vector<Pose> X_start;
  link_poses(robot, joint_values(robot, {0.0}), X_start);
  const auto link = [&](const std::string& name) {
    return index(std::find_if(robot.links.begin(), robot.links.end(),
                              [&](const Link& l) { return l.name == name; }) -
                 robot.links.begin());
  };
  const Vector3 p_A(0.039, 0.0, 0.001);
  const Vector3 p_B = X_start[link("rocker")].inverse() * (X_start[link("coupler")] * p_A);
  for (int i = 0; i <= 10; ++i) {
    std::vector<Pose> X;
    link_poses(robot, joint_values(robot, {robot.dofs[0].upper * i / 10.0}), X);
    EXPECT_LT((X[link("coupler")] * p_A - X[link("rocker")] * p_B).norm(), 1e-3) << i;
  }
}

TEST(LoopClosure, ThatCannotBeClosedIsLeftOut) {
  const Robot robot = read_text(parallelogram("0.04 0 0\" solref=\"0.1 1")).robots.at(0).robot;
  ASSERT_EQ(robot.dofs.size(), 1U);
  std::string text = parallelogram("0.04 0 0");
  const std::string rocker = "range=\"-90 90\"/><geom size=\"0.01\"/></body></body></worldbody>";
  text.replace(text.find(rocker), 14, "range=\"0 10\"  ");
  const Robot stuck = read_text(text).robots.at(0).robot;
  EXPECT_EQ(stuck.dofs.size(), 3U);
  EXPECT_TRUE(has_note(stuck, "cannot be closed"));
}

}  // namespace
}  // namespace prehend
