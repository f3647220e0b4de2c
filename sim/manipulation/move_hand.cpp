#include "sim/manipulation/move_hand.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/motion/control/stated_gains.h"

namespace prehend {
namespace {

// Joints of an arm whose file states no gains are held by critically damped PD controllers of this
// frequency [Hz].
constexpr double kFrequency = 10.0;

bool is_of_hand(int dof, const WorldHand& hand) {
  return dof >= hand.first_dof && dof < hand.first_dof + hand.dofs;
}

void move_base(const Pose& to, double step, WorldRobot& robot) {
  const Pose& from = robot.X_WB;
  robot.base_linear = (to.translation() - from.translation()) / step;
  const Eigen::AngleAxisd turn(Matrix3(to.linear() * from.linear().transpose()));
  robot.base_angular = turn.angle() / step * turn.axis();
}

}  // namespace

std::vector<Drive> arm_drives(const WorldRobot& robot, const WorldHand& hand) {
  const RobotModel& model = *robot.model;
  const PdGains gains = stated_gains(robot, kFrequency);
  std::vector<Drive> drives;
  for (int d = 0; d < static_cast<int>(model.dofs()); ++d) {
    if (is_of_hand(d, hand)) continue;
    drives.push_back({.dof = d,
                      .stiffness = gains.stiffness[d],
                      .damping = gains.damping[d],
                      .target = robot.x[d],
                      .max_effort = model.effort[d]});
  }
  return drives;
}

HandMover::HandMover(const World& world, const WorldHand& hand)
    : hand_(hand), X_WH_(hand_pose(world, hand)) {
  const WorldRobot& robot = world.robots[index(hand.robot)];
  posture_.assign(robot.x.data(), robot.x.data() + robot.model->dofs());
  for (const Drive& drive : robot.drives) {
    if (!is_of_hand(drive.dof, hand)) posture_[index(drive.dof)] = drive.target;
  }
}

bool HandMover::move(const Pose& X_WH, double step, World& world) {
  WorldRobot& robot = world.robots[index(hand_.robot)];
  if (hand_.is_free()) {
    move_base(X_WH * hand_.X_JH.inverse(), step, robot);
    return true;
  }
  DofValues next = posture_;
  if (X_WH.matrix() != X_WH_.matrix()) {
    const IkTarget target{hand_.joint, hand_.X_JH, robot.X_WB.inverse() * X_WH};
    const auto found = solve_near(robot.model->robot, {target}, posture_);
    if (!found) return false;
    next = *found;
  }
  for (Drive& drive : robot.drives) {
    if (is_of_hand(drive.dof, hand_)) continue;
    drive.target = next[index(drive.dof)];
    drive.target_rate = (next[index(drive.dof)] - posture_[index(drive.dof)]) / step;
  }
  posture_ = next;
  X_WH_ = X_WH;
  return true;
}

void HandMover::stop(World& world) const {
  WorldRobot& robot = world.robots[index(hand_.robot)];
  robot.base_linear.setZero();
  robot.base_angular.setZero();
  for (Drive& drive : robot.drives) {
    if (!is_of_hand(drive.dof, hand_)) drive.target_rate = 0.0;
  }
}

}  // namespace prehend
