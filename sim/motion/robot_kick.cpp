#include "sim/motion/robot_kick.h"

#include <Eigen/Cholesky>

#include "sim/motion/joint_springs.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/motion/spatial.h"

namespace prehend {
namespace {

RobotSurroundings around(const WorldRobot& robot, const Vector3& gravity_W, double step) {
  const Matrix3 R_BW = robot.X_WB.linear().transpose();
  RobotSurroundings around;
  around.gravity_B = R_BW * gravity_W;
  around.base_velocity = spatial(R_BW * robot.base_angular, R_BW * robot.base_linear);
  // The spatial acceleration of B's origin: what changes of its velocity besides the turn.
  const Vector3 angular = (robot.base_angular - robot.last_base_angular) / step;
  const Vector3 linear = (robot.base_linear - robot.last_base_linear) / step -
                         robot.base_angular.cross(robot.base_linear);
  around.base_acceleration = spatial(R_BW * angular, R_BW * linear);
  return around;
}

// What acts at `rate`, besides springs and friction.
Eigen::VectorXd push_at(const WorldRobot& robot, const Eigen::VectorXd& q,
                        const Eigen::VectorXd& rate, const RobotSurroundings& around) {
  const RobotModel& model = *robot.model;
  Eigen::VectorXd push = Eigen::VectorXd::Zero(rate.size());
  if (!robot.is_balanced) {
    push -= model.joints_of.transpose() * model.dynamics->bias(q, model.joints_of * rate, around);
  }
  if (robot.effort.size() > 0) push.head(model.dofs()) += robot.effort;
  return push;
}

Eigen::MatrixXd mass_at(const RobotModel& model, const Eigen::VectorXd& q) {
  const Eigen::MatrixXd& C = model.joints_of;
  Eigen::MatrixXd mass = C.transpose() * model.dynamics->mass_matrix(q) * C;
  mass.diagonal() += model.drive_inertia;
  return mass;
}

void add_viscous(const RobotModel& model, double kick, Eigen::MatrixXd& mass) {
  for (std::size_t j = 0; j < model.robot.joints.size(); ++j) {
    const double viscous = model.robot.joints[j].friction.viscous;
    if (viscous == 0.0) continue;
    const auto row = model.joints_of.row(static_cast<Eigen::Index>(j));
    mass += kick * viscous * row.transpose() * row;
  }
}

}  // namespace

RobotKick kicked(const WorldRobot& robot, const Vector3& gravity_W, double step, double kick) {
  const RobotModel& model = *robot.model;
  const Eigen::VectorXd q = joints_of(robot);
  RobotKick result{.mass = mass_at(model, q)};
  result.momentum = result.mass * robot.rate +
                    kick * push_at(robot, q, robot.rate, around(robot, gravity_W, step));
  if (!robot.is_balanced) add_springs(model, q, kick, result.mass, result.momentum);
  add_viscous(model, kick, result.mass);
  return result;
}

// What depends on the rates is that of the rates searched for, which makes the halves mirror
// images: they are put in again and again, and each time the error shrinks with the step.
Eigen::VectorXd rates_after(const WorldRobot& robot, const Vector3& gravity_W, double step) {
  constexpr int kRounds = 3;
  const RobotModel& model = *robot.model;
  const Eigen::VectorXd q = joints_of(robot);
  const double kick = 0.5 * step;
  Eigen::MatrixXd mass = mass_at(model, q);
  Eigen::VectorXd before = mass * robot.rate;
  if (!robot.is_balanced) {
    const Eigen::VectorXd middle = q - kick * (model.joints_of * robot.rate);
    before += kick * model.joints_of.transpose() * spring_efforts(model.robot, middle);
  }
  add_viscous(model, kick, mass);
  const Eigen::LLT<Eigen::MatrixXd> factor(mass);
  const RobotSurroundings surroundings = around(robot, gravity_W, step);
  Eigen::VectorXd rate = robot.rate;
  for (int i = 0; i < kRounds; ++i) {
    rate = factor.solve(before + kick * push_at(robot, q, rate, surroundings));
  }
  return rate;
}

}  // namespace prehend
