// The linear system of one step of an interior point method (Karush-Kuhn-Tucker, KKT).
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

#include "sim/quality/conic/cone_scaling.h"

namespace prehend {

// Solves, for any right-hand side and for one scaling W after the other,
//
//   [0  A'  G'] [x]   [bx]
//   [A  0   0 ] [y] = [by]
//   [G  0  -WW] [z]   [bz]
//
// by orthogonal (QR) factors: x is split into its parts in the range of A' and in the null space of
// A, and what remains in the null space is a least squares problem with W^-1 G. The usual way, by
// Cholesky factors of G' W^-2 G, would square the condition number of W, which grows without bound
// as the iteration converges.
// Source: Vandenberghe, "The CVXOPT linear and quadratic cone program solvers", 2010, section 10.2.
class KktSystem {
 public:
  // A (p x n) must have linearly independent rows, and [A; G] linearly independent columns.
  KktSystem(const Eigen::MatrixXd& A, const Eigen::MatrixXd& G);

  // Sets W; must be called before solve(). `scaling` must live as long as solve() is called.
  void factor(const ConeScaling& scaling);

  // A right-hand side, or a solution, in its three blocks of n, p and m rows.
  struct Vector {
    Eigen::VectorXd x;
    Eigen::VectorXd y;
    Eigen::VectorXd z;
  };
  // The solution, after one step of iterative refinement.
  Vector solve(const Vector& right) const;

 private:
  Vector solve_once(const Vector& right) const;

  Eigen::MatrixXd matrix_A_;
  Eigen::MatrixXd matrix_G_;
  Eigen::MatrixXd range_;      // Q1, n x p: basis of the range of A' = Q1 R1
  Eigen::MatrixXd null_;       // Q2, n x (n - p): basis of the null space of A
  Eigen::MatrixXd upper_;      // R1, p x p, in its upper triangle
  Eigen::MatrixXd null_of_G_;  // G Q2
  const ConeScaling* scaling_ = nullptr;
  Eigen::HouseholderQR<Eigen::MatrixXd> scaled_;  // of W^-1 G Q2
};

}  // namespace prehend
