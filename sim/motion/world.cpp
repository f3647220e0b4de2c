#include "sim/motion/world.h"

#include <utility>

namespace prehend {

WorldRobot make_world_robot(std::string name, std::shared_ptr<const RobotModel> model,
                            const Pose& X_WB, const std::vector<double>& dofs,
                            const std::vector<double>& joints) {
  WorldRobot robot{.name = std::move(name), .model = std::move(model), .X_WB = X_WB};
  robot.x = coordinates_at(*robot.model, dofs, joints);
  robot.rate = Eigen::VectorXd::Zero(robot.x.size());
  return robot;
}

Eigen::VectorXd joints_of(const WorldRobot& robot) {
  return robot.model->joints_of * robot.x + robot.model->offset;
}

}  // namespace prehend
