#include "sim/dynamics/rigid_motion.h"

namespace prehend {
namespace {

Matrix3 turned_by(const Vector3& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) return Matrix3::Identity();
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

}  // namespace

Vector3 center_in_world(const Inertial& inertial, const Pose& X_WB) {
  return X_WB * inertial.center_of_mass;
}

Matrix3 inertia_in_world(const Inertial& inertial, const Pose& X_WB) {
  return X_WB.linear() * inertial.inertia * X_WB.linear().transpose();
}

Pose carried(const Inertial& inertial, const RigidMotion& motion, double time) {
  const Vector3 center = center_in_world(inertial, motion.X_WB) + time * motion.linear;
  // Rounding of the product is taken out, so that 1e5 steps leave a rotation.
  const Eigen::Quaterniond turned(turned_by(time * motion.angular) * motion.X_WB.linear());
  const Matrix3 rotation = turned.normalized().toRotationMatrix();
  return pose_from(rotation, center - rotation * inertial.center_of_mass);
}

Vector3 free_angular_velocity(const Inertial& inertial, const Pose& X_WB, const Vector3& momentum,
                              double time) {
  const auto velocity_at = [&](const Vector3& mean) {
    const Matrix3 rotation = turned_by(0.5 * time * mean) * X_WB.linear();
    const Vector3 momentum_B = rotation.transpose() * momentum;
    return Vector3(rotation * inertial.inertia.ldlt().solve(momentum_B));
  };
  Vector3 mean = velocity_at(Vector3::Zero());
  // A contraction while the body turns by a small part of a revolution in a step; it gains digits
  // with each round.
  constexpr int kRounds = 20;
  for (int i = 0; i < kRounds; ++i) {
    const Vector3 next = velocity_at(mean);
    const bool settled = (next - mean).norm() <= 1e-15 * next.norm();
    mean = next;
    if (settled) break;
  }
  return mean;
}

double kinetic_energy(const Inertial& inertial, const RigidMotion& motion) {
  return 0.5 * inertial.mass * motion.linear.squaredNorm() +
         0.5 * motion.angular.dot(inertia_in_world(inertial, motion.X_WB) * motion.angular);
}

}  // namespace prehend
