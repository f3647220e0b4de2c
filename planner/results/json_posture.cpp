#include "planner/results/json_posture.h"

#include <algorithm>

namespace prehend {
namespace {

// Files state numbers in decimal and may have been rounded, hence the tolerance.
bool within(double value, double lower, double upper) {
  return value >= lower - kLimitTolerance && value <= upper + kLimitTolerance;
}

}  // namespace

std::vector<double> read_dofs(const JsonField& field, const Robot& robot) {
  std::vector<double> dofs = field.numbers(robot.dofs.size());
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    const DegreeOfFreedom& dof = robot.dofs[d];
    if (!within(dofs[d], dof.lower, dof.upper)) field.fail(dof.name + " is outside its limits");
    dofs[d] = std::clamp(dofs[d], dof.lower, dof.upper);
  }
  return dofs;
}

std::vector<double> read_joints(const JsonField& field, const Robot& robot) {
  // Joints are not clamped, unlike degrees of freedom: they are read back as they were written.
  std::vector<double> joints = field.numbers(robot.joints.size());
  check_joint_limits(field, robot);
  return joints;
}

void check_joint_limits(const JsonField& field, const Robot& robot) {
  const std::vector<JsonField> items = field.items();
  for (std::size_t j = 0; j < items.size(); ++j) {
    const Joint& joint = robot.joints[j];
    if (!within(items[j].number(), joint.lower, joint.upper)) {
      items[j].fail(joint.name + " is outside its limits");
    }
  }
}

}  // namespace prehend
