#include "sim/motion/control/controller.h"

#include <utility>

namespace prehend {

Controller sum_of(std::vector<Controller> controllers) {
  return [all = std::move(controllers)](const ControlState& state) -> Eigen::VectorXd {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(state.robot.model->dofs());
    for (const Controller& controller : all) sum += controller(state);
    return sum;
  };
}

}  // namespace prehend
