#include "sim/motion/control/stated_gains.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/base/input_error.h"

namespace prehend {

PdGains stated_gains(const WorldRobot& robot, double frequency) {
  const std::vector<DegreeOfFreedom>& dofs = robot.model->robot.dofs;
  const Eigen::VectorXd inertia = moved_inertias(robot);
  PdGains gains = critically_damped(robot, frequency);
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    const auto at = static_cast<Eigen::Index>(d);
    if (dofs[d].stiffness) {
      gains.stiffness[at] = *dofs[d].stiffness;
      gains.damping[at] = 2.0 * std::sqrt(gains.stiffness[at] * inertia[at]);
    }
    if (dofs[d].damping) gains.damping[at] = *dofs[d].damping;
  }
  return gains;
}

Eigen::VectorXd set_points(const Robot& robot, const std::string& preshape) {
  const auto vector = [](const std::vector<double>& values) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  };
  if (preshape.empty()) return vector(initial_dofs(robot));
  const std::vector<Preshape> shapes = robot.hand ? robot.hand->preshapes : std::vector<Preshape>{};
  const auto found = std::find_if(shapes.begin(), shapes.end(),
                                  [&](const Preshape& shape) { return shape.name == preshape; });
  if (found == shapes.end()) {
    throw InputError({robot.name, "preshapes", "has no preshape of that name", preshape});
  }
  return vector(found->dofs);
}

std::vector<Drive> pd_drives(const RobotModel& model, const PdGains& gains,
                             const Eigen::VectorXd& values) {
  require_gains(model, gains);
  if (values.size() != model.dofs()) {
    throw InputError({model.robot.name, "values", "must have a number for each degree of freedom",
                      std::to_string(values.size())});
  }
  std::vector<Drive> drives;
  for (Eigen::Index d = 0; d < model.dofs(); ++d) {
    drives.push_back({.dof = static_cast<int>(d),
                      .stiffness = gains.stiffness[d],
                      .damping = gains.damping[d],
                      .target = values[d],
                      .max_effort = model.effort[d]});
  }
  return drives;
}

}  // namespace prehend
