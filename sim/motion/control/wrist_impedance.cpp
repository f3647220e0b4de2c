#include "sim/motion/control/wrist_impedance.h"

#include <cmath>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/motion/control/joint_controllers.h"
#include "sim/motion/robot_dynamics.h"
#include "sim/motion/solids.h"

namespace prehend {
namespace {

void require_not_negative(const std::string& name, double value) {
  if (value >= 0.0 && std::isfinite(value)) return;
  throw InputError(
      {.field = name, .problem = "must not be negative", .value = std::to_string(value)});
}

// Angle times axis of the rotation that takes the frame to the target, in world axes.
Vector3 rotation_between(const Matrix3& from, const Matrix3& to) {
  const Eigen::AngleAxisd turn(Matrix3(to * from.transpose()));
  return turn.angle() * turn.axis();
}

// With the inertia L that the arm has at its frame and the stiffness K there are Q and w with
// L = Q Q' and K = Q diag(w^2) Q'; the damping is 2 ratio Q diag(w) Q'.
Matrix6 damping_of(const WorldRobot& robot, const Eigen::MatrixXd& J, const Matrix6& stiffness,
                   double ratio) {
  // Where the arm is singular, no force moves the frame along some axis: its inertia there is
  // bounded by this part of the mobility along the others.
  constexpr double kSmallest = 1e-6;
  const RobotModel& model = *robot.model;
  Eigen::MatrixXd mass =
      model.joints_of.transpose() * model.dynamics->mass_matrix(joints_of(robot)) * model.joints_of;
  mass.diagonal() += model.drive_inertia;
  Matrix6 mobility = J * mass.llt().solve(J.transpose());
  mobility.diagonal().array() += kSmallest * mobility.trace();
  const Matrix6 inertia = mobility.llt().solve(Matrix6::Identity());
  const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6> modes(
      stiffness, 0.5 * (inertia + inertia.transpose()));
  const Matrix6 Q = modes.eigenvectors().inverse().transpose();
  const Vector6 frequencies = modes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return 2.0 * ratio * Q * frequencies.asDiagonal() * Q.transpose();
}

}  // namespace

Eigen::MatrixXd frame_jacobian(const WorldRobot& robot, int joint) {
  const RobotModel& model = *robot.model;
  const RobotState state = state_of(robot);
  const Vector3 at = state.X_WA[index(joint)].translation();
  Eigen::MatrixXd of_joints =
      Eigen::MatrixXd::Zero(6, static_cast<Eigen::Index>(model.robot.joints.size()));
  for (const int j : joints_to(model.robot, joint)) {
    const Vector3& axis = state.axis_W[index(j)];
    if (model.robot.joints[index(j)].type == JointType::revolute) {
      of_joints.col(j) << axis, axis.cross(at - state.origin_W[index(j)]);
    } else {
      of_joints.col(j) << Vector3::Zero(), axis;
    }
  }
  return of_joints * model.joints_of;
}

Controller wrist_impedance(const RobotModel& model, int joint, const Pose& X_WT,
                           const WristImpedance& impedance) {
  if (joint < 0 || index(joint) >= model.robot.joints.size()) {
    throw InputError(
        {model.robot.name, "joint", "the robot has no such joint", std::to_string(joint)});
  }
  require_not_negative("stiffness", impedance.stiffness);
  require_not_negative("turning_stiffness", impedance.turning_stiffness);
  require_not_negative("damping_ratio", impedance.damping_ratio);
  Vector6 springs;
  springs << Vector3::Constant(impedance.turning_stiffness), Vector3::Constant(impedance.stiffness);
  const Matrix6 stiffness = springs.asDiagonal();
  const double ratio = impedance.damping_ratio;
  const Controller weight = gravity_compensation();
  return [joint, X_WT, stiffness, ratio, weight](const ControlState& state) -> Eigen::VectorXd {
    const WorldRobot& robot = state.robot;
    const Pose X_WA = state_of(robot).X_WA[index(joint)];
    const Eigen::MatrixXd J = frame_jacobian(robot, joint);
    const Vector6 velocity = J * robot.rate;
    const Vector6 off = spatial(rotation_between(X_WA.linear(), X_WT.linear()),
                                X_WT.translation() - X_WA.translation());
    const Vector6 force = stiffness * off - damping_of(robot, J, stiffness, ratio) * velocity;
    const Eigen::VectorXd efforts = J.transpose() * force;
    return weight(state) + efforts.head(robot.model->dofs());
  };
}

}  // namespace prehend
