#include "sim/robot/joint_course.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

// Two fingers on one drive: each a bar and a tip that a linkage keeps parallel, the first one with
// a lever of its own on the palm, which the linkage joins to it.
Robot two_linkages() {
  Robot robot;
  robot.name = "made";
  robot.dofs = {{.name = "grip", .lower = 0.0, .upper = 1.0, .closing_velocity = 1.0}};
  robot.dofs[0].coupling = Coupling::by_finger;
  const auto add = [&](const char* name, int parent, double ratio) -> Joint& {
    Joint joint{.name = name};
    joint.lower = -1.0;
    joint.upper = 1.0;
    joint.parent = parent;
    joint.ratio = ratio;
    robot.joints.push_back(joint);
    return robot.joints.back();
  };
  add("left_lever", -1, 1.0);
  Joint& coupler = add("left_coupler", 0, 0.0);
  coupler.across = 2;
  coupler.ahead = -2.0;
  add("left_bar", -1, 1.0);
  Joint& left = add("left_tip", 2, -1.0);
  left.across = 2;
  left.ahead = 3.0;
  add("right_bar", -1, 1.0);
  add("right_tip", 4, -1.0);
  return robot;
}

JointCourse started(const Robot& robot) {
  JointCourse course;
  course.start(robot, {0.0}, {{.velocity = 1.0, .end = 1.0}});
  return course;
}

TEST(JointCourse, FingersHangTogetherByJointsAndLinkages) {
  EXPECT_EQ(first_joints_of_fingers(two_linkages()), (std::vector<int>{0, 0, 0, 0, 4, 4}));
}

TEST(JointCourse, FingersBehindAWristAreSeveral) {
  Robot robot = two_linkages();
  Joint wrist{.name = "wrist"};
  wrist.dof = 1;
  robot.dofs.push_back({.name = "wrist"});
  for (Joint& joint : robot.joints) {
    joint.parent += 1;
    if (joint.across >= 0) joint.across += 1;
  }
  robot.joints.insert(robot.joints.begin(), wrist);
  EXPECT_EQ(first_joints_of_fingers(robot), (std::vector<int>{0, 1, 1, 1, 1, 5, 5}));
}

TEST(JointCourse, TheBarThatIsStoppedTurnsTheTip) {
  const Robot robot = two_linkages();
  JointCourse course = started(robot);
  EXPECT_TRUE(gives_way(robot, 2));
  EXPECT_FALSE(gives_way(robot, 4));
  EXPECT_EQ(course.speed(3, 0.0), 2.0);  // it may turn
  course.stop_before({2}, 0.25);
  EXPECT_EQ(course.value(2, 9.0), 0.25);
  EXPECT_TRUE(course.stopped_by_contact()[2]);
  EXPECT_FALSE(course.stopped_by_contact()[3]);
  EXPECT_DOUBLE_EQ(course.value(3, 0.25), -0.25);
  EXPECT_DOUBLE_EQ(course.value(3, 0.5), -0.25 + 2.0 * 0.25);
  EXPECT_DOUBLE_EQ(course.value(1, 0.2), 0.0);
  EXPECT_DOUBLE_EQ(course.value(1, 0.5), -2.0 * 0.25);
  // The coupler comes to its limit of -1 first; with it ends the drive of this finger alone.
  for (const int joint : {0, 1, 3}) EXPECT_DOUBLE_EQ(course.until(joint), 0.75) << joint;
  EXPECT_DOUBLE_EQ(course.until(4), 1.0);
}

TEST(JointCourse, TheTipThatTouchesStopsItsFinger) {
  const Robot robot = two_linkages();
  JointCourse course = started(robot);
  course.stop_before({2, 3}, 0.5);
  for (const int joint : {0, 1, 2, 3}) EXPECT_EQ(course.until(joint), 0.5) << joint;
  for (const int joint : {4, 5}) EXPECT_EQ(course.until(joint), 1.0) << joint;
}

TEST(JointCourse, TheTipThatTouchesAfterItTurnedStopsTheRest) {
  const Robot robot = two_linkages();
  JointCourse course = started(robot);
  course.stop_before({2}, 0.25);
  course.stop_before({2, 3}, 0.5);
  EXPECT_DOUBLE_EQ(course.value(3, 9.0), 0.25);
  EXPECT_DOUBLE_EQ(course.value(0, 9.0), 0.5);
  EXPECT_DOUBLE_EQ(course.value(2, 9.0), 0.25);
}

}  // namespace
}  // namespace prehend
