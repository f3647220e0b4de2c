#include "sim/robot/files/loop_closure.h"

#include <algorithm>
#include <tuple>

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

// A finger like those of the two-finger Robotiq: driver and coupler, which a stop keeps from
// opening further, turn as one bar of a parallelogram with the rocker, until the rocker is stopped:
// then the coupler folds and raises the tip, at first by as much as the driver turns (two bars at
// right angles to the lever of the tip).
std::string folding_finger(const std::string& spring) {
  return "<mujoco model=\"made\"><worldbody><body name=\"palm\"><geom size=\"0.01\"/>"
         "<body name=\"driver\"><joint name=\"driver\" axis=\"0 1 0\" range=\"0 40\"/>"
         "<geom size=\"0.005\"/><body name=\"coupler\" pos=\"-0.02 0 0.03\"><joint "
         "name=\"coupler\" "
         "axis=\"0 1 0\" range=\"-120 0\"/><geom size=\"0.005\"/></body></body>"
         "<body name=\"rocker\" pos=\"0.04 0 0\"><joint name=\"rocker\" axis=\"0 1 0\" "
         "range=\"-40 60\"" +
         spring +
         "/><geom size=\"0.005\"/><body name=\"tip\" pos=\"0 0 0.06\"><joint name=\"tip\" "
         "axis=\"0 1 0\" range=\"-60 60\"/><geom size=\"0.005\"/></body></body></body></worldbody>"
         "<equality><connect body1=\"tip\" body2=\"coupler\" anchor=\"-0.04 0 0\"/></equality>"
         "<actuator><motor joint=\"driver\" forcerange=\"-1 1\"/></actuator></mujoco>";
}

TEST(LoopClosure, ASprungRockerGivesWayAndTheTipGoesOn) {
  const Robot robot =
      read_text(folding_finger(" stiffness=\"0.05\" springref=\"150\"")).robots.at(0).robot;
  ASSERT_EQ(robot.dofs.size(), 1U);
  ASSERT_EQ(robot.joints.size(), 4U);
  const auto joint = [&](const std::string& name) {
    return std::find_if(robot.joints.begin(), robot.joints.end(),
                        [&](const Joint& j) { return j.name == name; });
  };
  const auto rocker = joint("rocker");
  EXPECT_NEAR(rocker->ratio, 1.0, 1e-3);
  EXPECT_EQ(rocker->across, -1);
  EXPECT_GT(rocker->spring.stiffness, 0.0);
  for (const auto& [name, ratio, ahead] :
       {std::tuple("tip", -1.0, 2.0), std::tuple("coupler", 0.0, -2.0)}) {
    EXPECT_NEAR(joint(name)->ratio, ratio, 1e-3) << name;
    EXPECT_EQ(joint(name)->across, rocker - robot.joints.begin()) << name;
    EXPECT_NEAR(joint(name)->ahead, ahead, 0.4) << name;
  }
  EXPECT_TRUE(has_note(robot, "joint rocker is held by a spring"));
  // The points still meet when the rocker has been stopped.
  std::vector<double> values = joint_values(robot, {0.5});
  for (const double behind : {0.0, 0.1, 0.2}) {
    std::vector<double> stopped = values;
    for (std::size_t j = 0; j < values.size(); ++j) {
      if (robot.joints[j].across >= 0) stopped[j] += robot.joints[j].ahead * behind;
    }
    stopped[index(rocker - robot.joints.begin())] -= behind;
    std::vector<Pose> X;
    link_poses(robot, stopped, X);
    const auto link = [&](const std::string& name) {
      return X[index(std::find_if(robot.links.begin(), robot.links.end(),
                                  [&](const Link& l) { return l.name == name; }) -
                     robot.links.begin())];
    };
    const Vector3 opening =
        link("tip") * Vector3(-0.04, 0.0, 0.0) - link("coupler") * Vector3(0.02, 0.0, 0.03);
    EXPECT_LT(opening.norm(), 2e-4 + 0.02 * behind) << behind;
  }
}

TEST(LoopClosure, WithoutASpringNothingGivesWay) {
  const Robot robot = read_text(folding_finger("")).robots.at(0).robot;
  for (const Joint& joint : robot.joints) EXPECT_EQ(joint.across, -1) << joint.name;
}

}  // namespace
}  // namespace prehend
