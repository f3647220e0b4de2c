#include "sim/motion/rigid_motion.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace prehend {
namespace {

Matrix3 turned_by(const Vector3& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) return Matrix3::Identity();
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

// A turn by a rotation vector, exact to rounding also where it is tiny.
Eigen::Quaterniond turn_by(const Vector3& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) return Eigen::Quaterniond::Identity();
  const Vector3 v = std::sin(0.5 * angle) / angle * rotation;
  return {std::cos(0.5 * angle), v.x(), v.y(), v.z()};
}

Vector3 rotation_vector(const Eigen::Quaterniond& turn) {
  const double sine = turn.vec().norm();
  if (sine == 0.0) return Vector3::Zero();
  const double sign = turn.w() < 0.0 ? -1.0 : 1.0;
  return sign * 2.0 * std::atan2(sine, std::abs(turn.w())) / sine * turn.vec();
}

// A body that turns freely. Its energy is that of a ball of moment I, and corrections for each
// principal axis: with the inverse moments 1/I_k = 1/I + c_k,
//
//   2 E = L^2 / I + c_1 L_1^2 + c_2 L_2^2 + c_3 L_3^2
//
// Each part alone turns the body about a fixed axis. I is that of the two axes that are most alike,
// so that a symmetric top is exact.
class FreeTop {
 public:
  FreeTop(const Matrix3& inertia, const Matrix3& R_WB, const Vector3& momentum_W)
      : momentum_(momentum_W) {
    const Eigen::SelfAdjointEigenSolver<Matrix3> principal(inertia);
    axes_ = R_WB * principal.eigenvectors();
    const Vector3 inverse = principal.eigenvalues().cwiseInverse();
    const bool last_alike = inverse[1] - inverse[2] < inverse[0] - inverse[1];
    odd_ = last_alike ? 0 : 2;
    ball_ = 0.5 * (inverse[1] + inverse[2 - odd_]);
    correction_ = inverse.array() - ball_;
    const Vector3 along = axes_.transpose() * momentum_;
    fastest_ = std::sqrt(along.cwiseAbs2().dot(inverse) * inverse[0]);
  }

  // A bound on the angular velocity: all its energy about the axis of the smallest moment.
  double fastest() const { return fastest_; }

  // One step of Strang's splitting from a turn on.
  Eigen::Quaterniond turned(Eigen::Quaterniond turn, double time) const {
    const int second = 2 - odd_;
    about(1, 0.5 * time, turn);
    about(second, 0.5 * time, turn);
    about(odd_, time, turn);
    about(second, 0.5 * time, turn);
    about(1, 0.5 * time, turn);
    return (turn_by(time * ball_ * momentum_) * turn).normalized();
  }

 private:
  void about(int axis, double time, Eigen::Quaterniond& turn) const {
    const Vector3 axis_W = turn * axes_.col(axis);
    turn = turn_by(time * correction_[axis] * axis_W.dot(momentum_) * axis_W) * turn;
  }

  Vector3 momentum_;
  Matrix3 axes_;  // principal, in the world before the step
  Vector3 correction_;
  double ball_ = 0.0;
  double fastest_ = 0.0;
  int odd_ = 0;  // the axis that is least like the others: of the smallest or largest moment
};

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
  const FreeTop top(inertial.inertia, X_WB.linear(), momentum);
  // Parts of a step in which the body turns by no more than this [rad], and not more of them.
  constexpr double kTurn = 0.05;
  constexpr double kMostParts = 10000.0;
  const double parts = std::clamp(std::ceil(top.fastest() * time / kTurn), 1.0, kMostParts);
  Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
  for (int i = 0; i < static_cast<int>(parts); ++i) turned = top.turned(turned, time / parts);
  return rotation_vector(turned) / time;
}

double kinetic_energy(const Inertial& inertial, const RigidMotion& motion) {
  return 0.5 * inertial.mass * motion.linear.squaredNorm() +
         0.5 * motion.angular.dot(inertia_in_world(inertial, motion.X_WB) * motion.angular);
}

}  // namespace prehend
