// The linear equations of one step of an interior point method.
#pragma once

#include <Eigen/Core>
#include <Eigen/QR>

#include "sim/conic/cone_scaling.h"

namespace prehend {

// Solves, for any right-hand side and for one scaling W after the other,
//
//   [0  A'  G'] [x]   [bx]
//   [A  0   0 ] [y] = [by]
//   [G  0  -WW] [z]   [bz]
//
// in the null space of A, by orthogonal factors, so that the condition of W is not squared.
// Source: Vandenberghe, "The CVXOPT linear and quadratic cone program solvers", 2010, section 10.2.
class KktSystem {
 public:
  // A (p x n) has independent rows, and [A; G] independent columns.
  KktSystem(const Eigen::MatrixXd& A, const Eigen::MatrixXd& G);

  // Must be called before solve(); `scaling` must outlive the solutions.
  void factor(const ConeScaling& scaling);

  struct Vector {
    Eigen::VectorXd x;
    Eigen::VectorXd y;
    Eigen::VectorXd z;
  };
  // With one step of iterative refinement.
  Vector solve(const Vector& right) const;

 private:
  Vector solve_once(const Vector& right) const;

  Eigen::MatrixXd matrix_A_;
  Eigen::MatrixXd matrix_G_;
  Eigen::MatrixXd range_;  // Q1, of A': A' = Q1 R1
  Eigen::MatrixXd null_;   // Q2
  Eigen::MatrixXd upper_;  // R1
  Eigen::MatrixXd null_of_G_;
  const ConeScaling* scaling_ = nullptr;
  Eigen::HouseholderQR<Eigen::MatrixXd> scaled_;  // of W^-1 G Q2
};

}  // namespace prehend
