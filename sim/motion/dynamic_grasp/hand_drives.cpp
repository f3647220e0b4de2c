#include "sim/motion/dynamic_grasp/hand_drives.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"

namespace prehend {

std::vector<Drive> holding_drives(const RobotModel& model, const WorldHand& hand) {
  std::vector<Drive> drives;
  for (int d = hand.first_dof; d < hand.first_dof + hand.dofs; ++d) {
    drives.push_back({.dof = d, .holds_rate = true, .max_effort = model.effort[d]});
  }
  return drives;
}

std::vector<Drive> closing_drives(const RobotModel& model, const WorldHand& hand) {
  std::vector<Drive> drives = holding_drives(model, hand);
  for (Drive& drive : drives) {
    drive.target_rate = model.robot.dofs[index(drive.dof)].closing_velocity;
  }
  return drives;
}

std::vector<Drive> closing_drives(const RobotModel& model, const WorldHand& hand,
                                  const Closing& closing) {
  std::vector<Drive> drives = closing_drives(model, hand);
  for (Drive& drive : drives) {
    const double part = closing.effort(index(drive.dof - hand.first_dof));
    if (part == 0.0)
      drive.target_rate = 0.0;
    else
      drive.max_effort *= part;
  }
  return drives;
}

std::vector<Drive> opening_drives(const RobotModel& model, const WorldHand& hand,
                                  const Eigen::VectorXd& now, const std::vector<double>& open) {
  constexpr double kSlowing = 0.02;  // before the end, so that it is not overshot [s]
  std::vector<Drive> drives = closing_drives(model, hand);
  for (Drive& drive : drives) {
    const double way = open[index(drive.dof - hand.first_dof)] - now[drive.dof];
    const double speed = std::abs(drive.target_rate);
    drive.target_rate = std::clamp(way / kSlowing, -speed, speed);
  }
  return drives;
}

void set_hand_drives(const std::vector<Drive>& drives, const WorldHand& hand, WorldRobot& robot) {
  std::erase_if(robot.drives, [&](const Drive& drive) {
    return drive.dof >= hand.first_dof && drive.dof < hand.first_dof + hand.dofs;
  });
  robot.drives.insert(robot.drives.end(), drives.begin(), drives.end());
}

}  // namespace prehend
