// The normal equations of a Gauss-Newton step in which a shape's frame turns and its faces move.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/base/pose.h"

namespace prehend {

// normal * change = right, for N unknowns.
template <int N>
struct NormalEquations {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  Matrix normal = Matrix::Zero();
  Vector right = Vector::Zero();

  // Takes an unknown out of the step: its equation becomes 1 * change = 0.
  void fix(int unknown) {
    normal.row(unknown).setZero();
    normal.col(unknown).setZero();
    normal(unknown, unknown) = 1.0;
    right[unknown] = 0.0;
  }

  // The change of the unknowns. Relative damping (Marquardt) keeps it finite where the points leave
  // a direction open, such as the turn of a square face; it may still be infinite or NaN where they
  // are not finite.
  Vector damped_change() {
    constexpr double kDamping = 1e-4;
    normal.diagonal() *= 1.0 + kDamping;
    normal.diagonal().array() += 1e-12;
    return normal.ldlt().solve(right);
  }
};

// Turns a frame, whose axes are the columns of R_OP, by the small rotation vector `turn` [rad] in
// its own axes. Larger turns than a quarter radian leave the linearisation and are shortened to it.
inline void turn_frame(Matrix3& R_OP, Vector3 turn) {
  constexpr double kLargestTurn = 0.25;
  if (turn.norm() > kLargestTurn) turn *= kLargestTurn / turn.norm();
  if (!(turn.norm() > 0.0)) return;
  R_OP = R_OP * Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
}

}  // namespace prehend
