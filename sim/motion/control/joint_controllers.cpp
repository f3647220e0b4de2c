#include "sim/motion/control/joint_controllers.h"

#include <cmath>
#include <string>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/motion/joint_springs.h"
#include "sim/motion/robot_dynamics.h"

namespace prehend {
namespace {

// Angular frequency [rad/s].
double angular(double frequency) {
  if (!(frequency > 0.0) || !std::isfinite(frequency)) {
    throw InputError(
        {.field = "frequency", .problem = "must be above 0", .value = std::to_string(frequency)});
  }
  return 2.0 * std::acos(-1.0) * frequency;
}

void require_gain(const RobotModel& model, const std::string& name, const Eigen::VectorXd& gains) {
  if (gains.size() != model.dofs()) {
    throw InputError({model.robot.name, name, "must have a number for each degree of freedom",
                      std::to_string(gains.size())});
  }
  for (const double gain : gains) {
    if (gain >= 0.0 && std::isfinite(gain)) continue;
    throw InputError({model.robot.name, name, "must not be negative", std::to_string(gain)});
  }
}

// Gravity and the motion of the base as the robot's equation of motion needs them.
RobotSurroundings surroundings(const ControlState& state) {
  RobotSurroundings around;
  const Matrix3 R_BW = state.robot.X_WB.linear().transpose();
  around.gravity_B = R_BW * state.gravity_W;
  around.base_velocity = spatial(R_BW * state.robot.base_angular, R_BW * state.robot.base_linear);
  return around;
}

// The efforts of the degrees of freedom that give its coordinates the accelerations. Springs act in
// a step as they are at its end.
Eigen::VectorXd efforts_for(const ControlState& state, const Eigen::VectorXd& rate,
                            const Eigen::VectorXd& acceleration) {
  const WorldRobot& robot = state.robot;
  const RobotModel& model = *robot.model;
  const Eigen::VectorXd q = joints_of(robot);
  const Eigen::VectorXd next =
      q + state.step * (model.joints_of * (rate + state.step * acceleration));
  const Eigen::VectorXd joints =
      model.dynamics->inverse(q, model.joints_of * rate, model.joints_of * acceleration,
                              surroundings(state)) -
      spring_efforts(model.robot, next);
  const Eigen::VectorXd efforts =
      model.joints_of.transpose() * joints + model.drive_inertia.cwiseProduct(acceleration);
  return efforts.head(model.dofs());
}

}  // namespace

void require_gains(const RobotModel& model, const PdGains& gains) {
  require_gain(model, "stiffness", gains.stiffness);
  require_gain(model, "damping", gains.damping);
}

Eigen::VectorXd moved_inertias(const WorldRobot& robot) {
  const RobotModel& model = *robot.model;
  const Eigen::MatrixXd mass =
      model.joints_of.transpose() * model.dynamics->mass_matrix(joints_of(robot)) * model.joints_of;
  return (mass.diagonal() + model.drive_inertia).head(model.dofs());
}

PdGains critically_damped(const WorldRobot& robot, double frequency) {
  const double omega = angular(frequency);
  const Eigen::VectorXd inertia = moved_inertias(robot);
  return {omega * omega * inertia, 2.0 * omega * inertia};
}

Controller pd_controller(const RobotModel& model, const PdGains& gains, JointMotion motion) {
  require_gains(model, gains);
  return [gains, motion = std::move(motion)](const ControlState& state) -> Eigen::VectorXd {
    const Eigen::Index dofs = state.robot.model->dofs();
    const Eigen::VectorXd wanted = motion(state.time);
    const Eigen::VectorXd rate = (wanted - motion(state.time - state.step)) / state.step;
    return gains.stiffness.cwiseProduct(wanted - state.robot.x.head(dofs)) +
           gains.damping.cwiseProduct(rate - state.robot.rate.head(dofs));
  };
}

Controller gravity_compensation() {
  return [](const ControlState& state) -> Eigen::VectorXd {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(state.robot.x.size());
    return efforts_for(state, none, none);
  };
}

// A step takes the velocity v to v + a h and the value x to x + (v + a h) h. On the motion m, v is
// therefore (m(t) - m(t - h)) / h, and a the second difference of m.
Controller computed_torque(JointMotion motion, double frequency) {
  const double omega = angular(frequency);
  return [omega, motion = std::move(motion)](const ControlState& state) -> Eigen::VectorXd {
    const WorldRobot& robot = state.robot;
    const Eigen::Index dofs = robot.model->dofs();
    const Eigen::VectorXd here = motion(state.time);
    const Eigen::VectorXd rate = (here - motion(state.time - state.step)) / state.step;
    const Eigen::VectorXd next = (motion(state.time + state.step) - here) / state.step;
    Eigen::VectorXd acceleration = Eigen::VectorXd::Zero(robot.x.size());
    acceleration.head(dofs) = (next - rate) / state.step +
                              2.0 * omega * (rate - robot.rate.head(dofs)) +
                              omega * omega * (here - robot.x.head(dofs));
    return efforts_for(state, robot.rate, acceleration);
  };
}

}  // namespace prehend
