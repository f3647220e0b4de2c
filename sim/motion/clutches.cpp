#include "sim/motion/clutches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sim/base/index.h"
#include "sim/robot/joint_course.h"

namespace prehend {
namespace {

// Part of the effort of a degree of freedom that each breakaway clutch bears that does not say: as
// in the Barrett hand, 0.5 of 2.5 N m. Fingers that share a drive share its effort evenly.
constexpr double kClutchPart = 0.2;
// What a finger with a breakaway clutch holds at rest, over what its drive presses with: the usual
// figures of the Barrett hand are 20 N at the tip at rest and 15 N in motion. And by how much its
// gear gives way until it bears all it can, as the small play of gears and cables does [rad or m].
constexpr double kHolds = 4.0 / 3.0;
constexpr double kGearGive = 0.01;

// Whether joint k stands somewhere before joint j; none does before the base (j = -1).
bool stands_before(const Robot& robot, int k, int j) {
  if (j < 0) return false;
  for (int p = robot.joints[index(j)].parent; p >= 0; p = robot.joints[index(p)].parent) {
    if (p == k) return true;
  }
  return false;
}

std::vector<int> joints_of_dof(const Robot& robot, int dof) {
  std::vector<int> joints;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    if (robot.joints[j].dof == dof) joints.push_back(static_cast<int>(j));
  }
  return joints;
}

// A finger that breaks away bends at its first joints no further while the last ones go on: the
// last have no clutch, since nothing is left to go on behind them. Fingers that share a drive have
// one clutch each.
std::vector<Clutch> places_of_clutches(const Robot& robot) {
  std::vector<Clutch> clutches;
  const std::vector<int> first_joint = first_joints_of_fingers(robot);
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    const int dof = static_cast<int>(d);
    const std::vector<int> joints = joints_of_dof(robot, dof);
    if (robot.dofs[d].coupling == Coupling::breakaway) {
      for (const int k : joints) {
        const bool has_follower = std::any_of(joints.begin(), joints.end(),
                                              [&](int j) { return stands_before(robot, k, j); });
        if (!has_follower) continue;
        const double closes = robot.joints[index(k)].ratio * robot.dofs[d].closing_velocity;
        clutches.push_back({.dof = dof, .joints = {k}, .locks = closes < 0.0 ? -1.0 : 1.0});
      }
    }
    if (robot.dofs[d].coupling == Coupling::by_finger) {
      std::map<int, Clutch> of_finger;  // by its first joint
      for (const int j : joints) {
        Clutch& clutch = of_finger[first_joint[index(j)]];
        clutch.dof = dof;
        clutch.joints.push_back(j);
      }
      for (auto& [first, clutch] : of_finger) clutches.push_back(std::move(clutch));
    }
    for (const int j : joints) {
      if (!gives_way(robot, j)) continue;
      const double closes = robot.dofs[d].closing_velocity < 0.0 ? -1.0 : 1.0;
      clutches.push_back({.dof = dof, .joints = {j}, .stays_behind = closes});
    }
  }
  return clutches;
}

}  // namespace

Eigen::VectorXd joints_of_slip(const Robot& robot, const Clutch& clutch) {
  Eigen::VectorXd column = Eigen::VectorXd::Zero(std::ssize(robot.joints));
  const auto has = [&](int joint) {
    return std::find(clutch.joints.begin(), clutch.joints.end(), joint) != clutch.joints.end();
  };
  for (const int k : clutch.joints) column[k] = robot.joints[index(k)].ratio;
  for (int j = 0; j < static_cast<int>(robot.joints.size()); ++j) {
    const Joint& joint = robot.joints[index(j)];
    if (!has(joint.across) || has(j)) continue;
    column[j] -= joint.ahead * robot.joints[index(joint.across)].ratio;
  }
  return column;
}

Eigen::VectorXd stated_efforts(const Robot& robot) {
  Eigen::VectorXd efforts = Eigen::VectorXd::Zero(std::ssize(robot.dofs));
  for (const Joint& joint : robot.joints) {
    efforts[joint.dof] += std::abs(joint.ratio) * joint.max_effort;
  }
  return efforts;
}

std::vector<Clutch> clutches_of(const Robot& robot, const Eigen::VectorXd& efforts) {
  std::vector<Clutch> clutches = places_of_clutches(robot);
  for (Clutch& clutch : clutches) {
    const DegreeOfFreedom& dof = robot.dofs[index(clutch.dof)];
    if (clutch.stays_behind != 0.0) continue;
    const auto fingers = std::count_if(clutches.begin(), clutches.end(), [&](const Clutch& c) {
      return c.dof == clutch.dof && c.stays_behind == 0.0;
    });
    const double part =
        dof.coupling == Coupling::by_finger ? 1.0 / static_cast<double>(fingers) : kClutchPart;
    const double drive = efforts[clutch.dof];
    clutch.effort = dof.breakaway_effort > 0.0 ? dof.breakaway_effort : part * drive;
    if (clutch.locks == 0.0) continue;
    const double ratio = std::abs(robot.joints[index(clutch.joints.front())].ratio);
    clutch.gear_effort = std::max(kHolds * drive - clutch.effort, 0.0) / ratio;
    clutch.gear_stiffness = clutch.gear_effort / kGearGive;
  }
  return clutches;
}

}  // namespace prehend
