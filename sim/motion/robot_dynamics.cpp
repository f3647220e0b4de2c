#include "sim/motion/robot_dynamics.h"

#include <cassert>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/robot/sound_robot.h"

namespace prehend {
namespace {

using Index = Eigen::Index;

// The axis through the origin of J, in the frame A behind it: turning about it moves A's origin.
Vector6 axis_in(const Joint& joint) {
  const Vector6 axis_J = joint.type == JointType::revolute ? spatial(joint.axis, Vector3::Zero())
                                                           : spatial(Vector3::Zero(), joint.axis);
  return motion_in(joint.X_JA, axis_J);
}

Index at(std::size_t j) { return static_cast<Index>(j); }

}  // namespace

RobotDynamics::RobotDynamics(const Robot& robot) {
  require_sound(robot);
  for (const Joint& joint : robot.joints) bodies_.push_back({joint, axis_in(joint)});
  for (const Link& link : robot.links) {
    if (link.joint >= 0) bodies_[index(link.joint)].inertia_A += spatial_inertia(link.inertial);
  }
  // The mass that each joint moves with all others held still.
  const Eigen::MatrixXd mass = mass_matrix(JointVector::Zero(joints()));
  for (std::size_t j = 0; j < bodies_.size(); ++j) {
    if (mass(at(j), at(j)) > 0.0) continue;
    throw InputError({robot.name, "joint " + bodies_[j].joint.name,
                      "moves no mass: the links behind it need one for dynamics"});
  }
}

// X_PA of each joint: the frame after it in the frame after its parent.
std::vector<Pose> RobotDynamics::poses(const JointVector& q) const {
  assert(q.size() == joints());
  std::vector<Pose> X_PA;
  X_PA.reserve(bodies_.size());
  for (std::size_t j = 0; j < bodies_.size(); ++j) {
    const Joint& joint = bodies_[j].joint;
    X_PA.push_back(joint.X_PJ * across(joint, q[at(j)]));
  }
  return X_PA;
}

// Velocities and accelerations go out from the base, forces come back to it. Gravity is a base that
// accelerates upwards.
JointVector RobotDynamics::inverse(const JointVector& q, const JointVector& v, const JointVector& a,
                                   const RobotSurroundings& around) const {
  assert(v.size() == joints() && a.size() == joints());
  const std::vector<Pose> X_PA = poses(q);
  const Vector6 base_acceleration =
      around.base_acceleration - spatial(Vector3::Zero(), around.gravity_B);
  std::vector<Vector6> velocity(bodies_.size());
  std::vector<Vector6> acceleration(bodies_.size());
  std::vector<Vector6> force(bodies_.size());
  for (std::size_t j = 0; j < bodies_.size(); ++j) {
    const Body& body = bodies_[j];
    const int parent = body.joint.parent;
    const Vector6 own = body.S_A * v[at(j)];
    velocity[j] =
        motion_in(X_PA[j], parent < 0 ? around.base_velocity : velocity[index(parent)]) + own;
    acceleration[j] =
        motion_in(X_PA[j], parent < 0 ? base_acceleration : acceleration[index(parent)]) +
        body.S_A * a[at(j)] + cross_motion(velocity[j], own);
    force[j] =
        body.inertia_A * acceleration[j] + cross_force(velocity[j], body.inertia_A * velocity[j]);
    if (!around.forces_A.empty()) force[j] -= around.forces_A[j];
  }
  JointVector effort(joints());
  for (std::size_t j = bodies_.size(); j-- > 0;) {
    effort[at(j)] = bodies_[j].S_A.dot(force[j]);
    const int parent = bodies_[j].joint.parent;
    if (parent >= 0) force[index(parent)] += force_out(X_PA[j], force[j]);
  }
  return effort;
}

JointVector RobotDynamics::bias(const JointVector& q, const JointVector& v,
                                const RobotSurroundings& around) const {
  return inverse(q, v, JointVector::Zero(joints()), around);
}

// Column j is the effort that a unit acceleration of joint j takes: of the composite body behind
// it, carried back along its parents.
Eigen::MatrixXd RobotDynamics::mass_matrix(const JointVector& q) const {
  const std::vector<Pose> X_PA = poses(q);
  std::vector<Matrix6> composite(bodies_.size());
  for (std::size_t j = 0; j < bodies_.size(); ++j) composite[j] = bodies_[j].inertia_A;
  for (std::size_t j = bodies_.size(); j-- > 0;) {
    const int parent = bodies_[j].joint.parent;
    if (parent < 0) continue;
    const Matrix6 X = motion_matrix(X_PA[j]);
    composite[index(parent)] += X.transpose() * composite[j] * X;
  }
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(joints(), joints());
  for (std::size_t j = 0; j < bodies_.size(); ++j) {
    Vector6 force = composite[j] * bodies_[j].S_A;
    mass(at(j), at(j)) = bodies_[j].S_A.dot(force);
    for (auto k = static_cast<int>(j); bodies_[index(k)].joint.parent >= 0;) {
      force = force_out(X_PA[index(k)], force);
      k = bodies_[index(k)].joint.parent;
      mass(at(j), k) = mass(k, at(j)) = bodies_[index(k)].S_A.dot(force);
    }
  }
  return mass;
}

// Featherstone's articulated bodies: what is behind a joint appears to the body before it as an
// inertia and a force of its own, since the joint is free to give way.
JointVector RobotDynamics::forward(const JointVector& q, const JointVector& v,
                                   const JointVector& effort,
                                   const RobotSurroundings& around) const {
  assert(v.size() == joints() && effort.size() == joints());
  const std::vector<Pose> X_PA = poses(q);
  const std::size_t n = bodies_.size();
  std::vector<Vector6> velocity(n);
  std::vector<Vector6> drift(n);  // acceleration that the velocities cause
  std::vector<Matrix6> inertia(n);
  std::vector<Vector6> force(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Body& body = bodies_[j];
    const int parent = body.joint.parent;
    const Vector6 own = body.S_A * v[at(j)];
    velocity[j] =
        motion_in(X_PA[j], parent < 0 ? around.base_velocity : velocity[index(parent)]) + own;
    drift[j] = cross_motion(velocity[j], own);
    inertia[j] = body.inertia_A;
    force[j] = cross_force(velocity[j], body.inertia_A * velocity[j]);
    if (!around.forces_A.empty()) force[j] -= around.forces_A[j];
  }
  std::vector<Vector6> U(n);
  std::vector<double> D(n);
  std::vector<double> u(n);
  for (std::size_t j = n; j-- > 0;) {
    U[j] = inertia[j] * bodies_[j].S_A;
    D[j] = bodies_[j].S_A.dot(U[j]);
    u[j] = effort[at(j)] - bodies_[j].S_A.dot(force[j]);
    const int parent = bodies_[j].joint.parent;
    if (parent < 0) continue;
    const Matrix6 seen = inertia[j] - U[j] * U[j].transpose() / D[j];
    const Vector6 pull = force[j] + seen * drift[j] + U[j] * (u[j] / D[j]);
    const Matrix6 X = motion_matrix(X_PA[j]);
    inertia[index(parent)] += X.transpose() * seen * X;
    force[index(parent)] += force_out(X_PA[j], pull);
  }
  const Vector6 base_acceleration =
      around.base_acceleration - spatial(Vector3::Zero(), around.gravity_B);
  JointVector result(joints());
  std::vector<Vector6> acceleration(n);
  for (std::size_t j = 0; j < n; ++j) {
    const int parent = bodies_[j].joint.parent;
    const Vector6 carried =
        motion_in(X_PA[j], parent < 0 ? base_acceleration : acceleration[index(parent)]) + drift[j];
    result[at(j)] = (u[j] - U[j].dot(carried)) / D[j];
    acceleration[j] = carried + bodies_[j].S_A * result[at(j)];
  }
  return result;
}

double RobotDynamics::kinetic_energy(const JointVector& q, const JointVector& v) const {
  const std::vector<Pose> X_PA = poses(q);
  std::vector<Vector6> velocity(bodies_.size());
  double energy = 0.0;
  for (std::size_t j = 0; j < bodies_.size(); ++j) {
    const int parent = bodies_[j].joint.parent;
    velocity[j] = bodies_[j].S_A * v[at(j)];
    if (parent >= 0) velocity[j] += motion_in(X_PA[j], velocity[index(parent)]);
    energy += 0.5 * velocity[j].dot(bodies_[j].inertia_A * velocity[j]);
  }
  return energy;
}

Eigen::MatrixXd coupling_matrix(const Robot& robot) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(at(robot.joints.size()), at(robot.dofs.size()));
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    matrix(at(j), robot.joints[j].dof) = robot.joints[j].ratio;
  }
  return matrix;
}

}  // namespace prehend
