#include "sim/motion/joint_springs.h"

namespace prehend {

Eigen::VectorXd spring_efforts(const Robot& robot, const Eigen::VectorXd& q) {
  Eigen::VectorXd efforts = Eigen::VectorXd::Zero(q.size());
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const JointSpring& spring = robot.joints[j].spring;
    // Where there is none, its rest may be anything.
    if (spring.stiffness == 0.0) continue;
    const auto at = static_cast<Eigen::Index>(j);
    efforts[at] = spring.stiffness * (spring.rest - q[at]);
  }
  return efforts;
}

double spring_energy(const Robot& robot, const Eigen::VectorXd& q) {
  double energy = 0.0;
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const JointSpring& spring = robot.joints[j].spring;
    if (spring.stiffness == 0.0) continue;
    const double stretch = q[static_cast<Eigen::Index>(j)] - spring.rest;
    energy += 0.5 * spring.stiffness * stretch * stretch;
  }
  return energy;
}

void add_springs(const RobotModel& model, const Eigen::VectorXd& q, double time,
                 Eigen::MatrixXd& mass, Eigen::VectorXd& momentum) {
  const Eigen::VectorXd efforts = spring_efforts(model.robot, q);
  for (std::size_t j = 0; j < model.robot.joints.size(); ++j) {
    const double stiffness = model.robot.joints[j].spring.stiffness;
    if (stiffness == 0.0) continue;
    const auto at = static_cast<Eigen::Index>(j);
    const auto row = model.joints_of.row(at);
    momentum += time * efforts[at] * row.transpose();
    mass += time * time * stiffness * row.transpose() * row;
  }
}

}  // namespace prehend
