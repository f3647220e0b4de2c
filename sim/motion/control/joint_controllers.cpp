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

// The efforts of the degrees of freedom that give its coordinates the accelerations.
Eigen::VectorXd efforts_for(const ControlState& state, const Eigen::VectorXd& rate,
                            const Eigen::VectorXd& acceleration) {
  const WorldRobot& robot = state.robot;
  const RobotModel& model = *robot.model;
  const Eigen::VectorXd q = joints_of(robot);
  const Eigen::VectorXd joints =
      model.dynamics->inverse(q, model.joints_of * rate, model.joints_of * acceleration,
                              surroundings(state)) -
      spring_efforts(model.robot, q);
  const Eigen::VectorXd efforts =
      model.joints_of.transpose() * joints + model.drive_inertia.cwiseProduct(acceleration);
  return efforts.head(model.dofs());
}

// Of a motion, to second order in the step.
Eigen::VectorXd rate_of(const JointMotion& motion, double time, double step) {
  return (motion(time + step) - motion(time - step)) / (2.0 * step);
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
    const Eigen::VectorXd rate = rate_of(motion, state.time, state.step);
    return gains.stiffness.cwiseProduct(motion(state.time) - state.robot.x.head(dofs)) +
           gains.damping.cwiseProduct(rate - state.robot.rate.head(dofs));
  };
}

Controller gravity_compensation() {
  return [](const ControlState& state) -> Eigen::VectorXd {
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(state.robot.x.size());
    return efforts_for(state, none, none);
  };
}

// A step takes the velocity v to v + a h and the value x to x + v h + a h^2 / 2, so that a is what
// the rate of the motion changes by in the step. The efforts act during all of it: they are those
// that are needed in its middle.
Controller computed_torque(JointMotion motion, double frequency) {
  const double omega = angular(frequency);
  return [omega, motion = std::move(motion)](const ControlState& state) -> Eigen::VectorXd {
    const WorldRobot& robot = state.robot;
    const Eigen::Index dofs = robot.model->dofs();
    const Eigen::VectorXd rate = rate_of(motion, state.time, state.step);
    const Eigen::VectorXd next = rate_of(motion, state.time + state.step, state.step);
    Eigen::VectorXd acceleration = Eigen::VectorXd::Zero(robot.x.size());
    acceleration.head(dofs) = (next - rate) / state.step +
                              2.0 * omega * (rate - robot.rate.head(dofs)) +
                              omega * omega * (motion(state.time) - robot.x.head(dofs));
    WorldRobot middle = robot;
    middle.rate += 0.5 * state.step * acceleration;
    middle.x += 0.25 * state.step * (robot.rate + middle.rate);
    return efforts_for({state.time, state.step, middle, state.gravity_W}, middle.rate,
                       acceleration);
  };
}

}  // namespace prehend
