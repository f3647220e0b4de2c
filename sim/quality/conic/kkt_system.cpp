#include "sim/quality/conic/kkt_system.h"

namespace prehend {

// What does not depend on W is computed once: the full QR factors of A', whose Q = [Q1 Q2] has the
// range of A' and the null space of A, and G Q2.
KktSystem::KktSystem(const Eigen::MatrixXd& A, const Eigen::MatrixXd& G)
    : matrix_A_(A), matrix_G_(G) {
  const Eigen::Index p = A.rows();
  const Eigen::Index n = A.cols();
  Eigen::MatrixXd Q = Eigen::MatrixXd::Identity(n, n);
  if (p > 0) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> factors(A.transpose());
    Q = factors.householderQ() * Q;
    upper_ = factors.matrixQR().topRows(p);
  }
  range_ = Q.leftCols(p);
  null_ = Q.rightCols(n - p);
  null_of_G_ = matrix_G_ * null_;
}

void KktSystem::factor(const ConeScaling& scaling) {
  scaling_ = &scaling;
  if (null_.cols() > 0) scaled_.compute(scaling.apply_inverse(null_of_G_));
}

// One step of iterative refinement: the solution's residual is solved for again and the result
// added. It takes back most of the rounding that an ill-conditioned W causes.
KktSystem::Vector KktSystem::solve(const Vector& right) const {
  Vector solution = solve_once(right);
  const Vector left = {
      right.x - matrix_A_.transpose() * solution.y - matrix_G_.transpose() * solution.z,
      right.y - matrix_A_ * solution.x,
      right.z - matrix_G_ * solution.x + scaling_->apply(scaling_->apply(solution.z))};
  const Vector correction = solve_once(left);
  solution.x += correction.x;
  solution.y += correction.y;
  solution.z += correction.z;
  return solution;
}

// Write x = Q1 a + Q2 d. The second equation, A x = by, gives a by R1' a = by. With the QR factors
// W^-1 G Q2 = Q R and e = W^-1 (bz - G Q1 a), the third equation is W z = Q R d - e; put into the
// first one, multiplied by Q2' (which removes y), it gives
//   R d = R'^-1 Q2' bx + Q' e,   W z = Q R'^-1 Q2' bx - (I - Q Q') e.
// The first equation multiplied by Q1' then gives y by R1 y = Q1' (bx - G' z).
KktSystem::Vector KktSystem::solve_once(const Vector& right) const {
  Vector solution;
  const Eigen::Index k = null_.cols();
  const auto triangle = upper_.triangularView<Eigen::Upper>();
  solution.x = Eigen::VectorXd::Zero(null_.rows());
  if (matrix_A_.rows() > 0) solution.x = range_ * triangle.transpose().solve(right.y);
  Eigen::VectorXd e = scaling_->apply_inverse(right.z - matrix_G_ * solution.x);
  if (k > 0) {
    const auto R = scaled_.matrixQR().topRows(k).triangularView<Eigen::Upper>();
    const Eigen::VectorXd gradient = R.transpose().solve(null_.transpose() * right.x);
    e.applyOnTheLeft(scaled_.householderQ().transpose());
    solution.x += null_ * R.solve(gradient + e.head(k));
    e = -e;
    e.head(k) = gradient;
    e.applyOnTheLeft(scaled_.householderQ());
  } else {
    e = -e;
  }
  solution.z = scaling_->apply_inverse(e);
  solution.y = Eigen::VectorXd::Zero(matrix_A_.rows());
  if (matrix_A_.rows() > 0) {
    solution.y =
        triangle.solve(range_.transpose() * (right.x - matrix_G_.transpose() * solution.z));
  }
  return solution;
}

}  // namespace prehend
