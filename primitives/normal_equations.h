// The normal equations of a Gauss-Newton step in which a shape's frame turns and its faces move.
#pragma once

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

  // The change of the unknowns, from the lower triangle of `normal`, which is lost. Relative
  // damping (Marquardt) keeps it finite where the points leave a direction open, such as the turn
  // of a square face; it may still be infinite or NaN where they are not finite.
  Vector damped_change() {
    constexpr double kDamping = 1e-4;
    normal.diagonal() *= 1.0 + kDamping;
    normal.diagonal().array() += 1e-12;
    factorize();
    for (int i = 0; i < N; ++i) {
      for (int k = 0; k < i; ++k) right[i] -= normal(i, k) * right[k];
    }
    right.array() /= normal.diagonal().array();
    for (int i = N - 1; i >= 0; --i) {
      for (int k = i + 1; k < N; ++k) right[i] -= normal(k, i) * right[k];
    }
    return right;
  }

 private:
  // The lower triangle becomes L (with ones in place of its diagonal) and D on the diagonal, of
  // normal = L D L^T. Without pivots, since the damping makes the matrix positive definite: that
  // takes a fraction of the time of Eigen's LDLT for so few unknowns.
  void factorize() {
    for (int j = 0; j < N; ++j) {
      for (int k = 0; k < j; ++k) {
        const double scaled = normal(j, k) * normal(k, k);
        for (int i = j; i < N; ++i) normal(i, j) -= normal(i, k) * scaled;
      }
      const double inverse = 1.0 / normal(j, j);
      for (int i = j + 1; i < N; ++i) normal(i, j) *= inverse;
    }
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
