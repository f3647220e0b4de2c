#include "sim/robot/files/urdf_form.h"

#include <cmath>
#include <string>
#include <utility>

#include "sim/base/index.h"

namespace prehend {
namespace {

// The joint that stands for the degree of freedom, -1: it drives none.
int leader_of(const Robot& robot, int dof) {
  int leader = -1;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (joint.dof != dof || joint.ratio == 0.0) continue;
    if (leader < 0) leader = static_cast<int>(j);
    if (joint.ratio == 1.0 && joint.offset == 0.0) return static_cast<int>(j);
  }
  return leader;
}

// Values of the degree of freedom are ratio * old + offset from now on.
void change_variable(Robot& robot, int dof, double ratio, double offset) {
  DegreeOfFreedom& motion = robot.dofs[index(dof)];
  const auto changed = [&](double value) { return ratio * value + offset; };
  motion.lower = changed(motion.lower);
  motion.upper = changed(motion.upper);
  if (ratio < 0.0) std::swap(motion.lower, motion.upper);
  motion.initial = changed(motion.initial);
  motion.closing_velocity *= ratio;
  motion.max_velocity *= std::abs(ratio);
  motion.max_acceleration *= std::abs(ratio);
  // Efforts of the new variable are 1 / ratio times those of the old one.
  if (motion.stiffness) *motion.stiffness /= ratio * ratio;
  if (motion.damping) *motion.damping /= ratio * ratio;
  for (Joint& joint : robot.joints) {
    if (joint.dof != dof) continue;
    joint.ratio /= ratio;
    joint.offset -= joint.ratio * offset;
  }
  if (!robot.hand) return;
  for (Preshape& preshape : robot.hand->preshapes) {
    preshape.dofs[index(dof)] = changed(preshape.dofs[index(dof)]);
  }
}

}  // namespace

Robot urdf_form(const Platform& platform, const MountedRobot& mounted) {
  const std::string prefix = platform.robots.size() > 1 ? mounted.name + "_" : "";
  Robot robot = mounted.robot;
  for (Joint& joint : robot.joints) {
    joint.name = joint.driver_name.empty() ? prefix + joint.name : joint.driver_name;
  }
  for (std::size_t d = 0; d < robot.dofs.size(); ++d) {
    const int dof = static_cast<int>(d);
    const int leader = leader_of(robot, dof);
    if (leader < 0) continue;
    Joint& joint = robot.joints[index(leader)];
    if (joint.ratio != 1.0 || joint.offset != 0.0) {
      change_variable(robot, dof, joint.ratio, joint.offset);
      joint.ratio = 1.0;
      joint.offset = 0.0;
    }
    robot.dofs[d].name = joint.name;
  }
  const auto rename = [&](auto& named) {
    for (auto& one : named) one.name = prefix + one.name;
  };
  rename(robot.chains);
  rename(robot.links);
  return robot;
}

}  // namespace prehend
