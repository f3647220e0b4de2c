// Spatial vectors: motions and forces of rigid bodies as six numbers. Source: Featherstone 2008,
// Rigid Body Dynamics Algorithms, chapter 2.
#pragma once

#include "sim/base/pose.h"
#include "sim/robot/inertial.h"

namespace prehend {

// A motion (velocity, acceleration): angular part, then the linear part of the frame's origin
// [rad/s, m/s]. A force: the moment about the frame's origin, then the force [N m, N].
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

inline Vector6 spatial(const Vector3& angular, const Vector3& linear) {
  Vector6 both;
  both << angular, linear;
  return both;
}

// v x: the matrix of the cross product.
inline Matrix3 cross_matrix(const Vector3& v) {
  Matrix3 matrix;
  matrix << 0.0, -v.z(), v.y(),  //
      v.z(), 0.0, -v.x(),        //
      -v.y(), v.x(), 0.0;
  return matrix;
}

// A motion given in frame A, in frame B.
inline Vector6 motion_in(const Pose& X_AB, const Vector6& motion_A) {
  const Vector3 angular = motion_A.head<3>();
  const Vector3 linear = motion_A.tail<3>() + angular.cross(X_AB.translation());
  return spatial(X_AB.linear().transpose() * angular, X_AB.linear().transpose() * linear);
}

// A force given in frame B, in frame A.
inline Vector6 force_out(const Pose& X_AB, const Vector6& force_B) {
  const Vector3 force = X_AB.linear() * force_B.tail<3>();
  return spatial(X_AB.linear() * force_B.head<3>() + X_AB.translation().cross(force), force);
}

// The rate of change of a motion that is carried along with velocity v, and of a force.
inline Vector6 cross_motion(const Vector6& v, const Vector6& motion) {
  const Vector3 w = v.head<3>();
  return spatial(w.cross(motion.head<3>()),
                 w.cross(motion.tail<3>()) + v.tail<3>().cross(motion.head<3>()));
}
inline Vector6 cross_force(const Vector6& v, const Vector6& force) {
  const Vector3 w = v.head<3>();
  return spatial(w.cross(force.head<3>()) + v.tail<3>().cross(force.tail<3>()),
                 w.cross(force.tail<3>()));
}

// The matrix of motions in A to motions in B: motion_in as a matrix. Its transpose turns forces in
// B into forces in A.
inline Matrix6 motion_matrix(const Pose& X_AB) {
  Matrix6 matrix = Matrix6::Zero();
  matrix.topLeftCorner<3, 3>() = X_AB.linear().transpose();
  matrix.bottomRightCorner<3, 3>() = X_AB.linear().transpose();
  const Matrix3 lever = cross_matrix(Vector3(-X_AB.translation()));
  matrix.bottomLeftCorner<3, 3>().noalias() = X_AB.linear().transpose() * lever;
  return matrix;
}

// The inertia about the origin of the frame in which `inertial` is given: momentum = inertia *
// velocity.
inline Matrix6 spatial_inertia(const Inertial& inertial) {
  const Matrix3 c = cross_matrix(inertial.center_of_mass);
  Matrix6 matrix;
  matrix.topLeftCorner<3, 3>() = inertial.inertia + inertial.mass * c * c.transpose();
  matrix.topRightCorner<3, 3>() = inertial.mass * c;
  matrix.bottomLeftCorner<3, 3>() = inertial.mass * c.transpose();
  matrix.bottomRightCorner<3, 3>() = inertial.mass * Matrix3::Identity();
  return matrix;
}

}  // namespace prehend
