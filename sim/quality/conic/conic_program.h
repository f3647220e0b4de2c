// Linear and second-order cone programs, for small dense problems.
#pragma once

#include <Eigen/Core>

#include "sim/quality/conic/cone.h"

namespace prehend {

// Minimise c'x over x in R^n subject to A x = b and h - G x in the cone. A may have no rows, and so
// may G.
struct ConicProgram {
  Eigen::VectorXd c;  // n
  Eigen::MatrixXd A;  // p x n
  Eigen::VectorXd b;  // p
  Eigen::MatrixXd G;  // m x n
  Eigen::VectorXd h;  // m
  ConeSizes cone;     // of m rows
};

// How the solver ended.
enum class ConicStatus {
  optimal,
  primal_infeasible,  // proved: no x meets the constraints
  dual_infeasible,    // proved: c'x has no lower bound, if any x meets the constraints
  limit,              // iterations used up, or rounding stalls; the best iterate stands, be it a
                      // solution or y and z of a certificate that is not good enough
};

// When the iteration stops. Tolerances apply to the equilibrated program: dual residuals relative
// to the largest entry of c, primal ones to that of b and h.
struct ConicOptions {
  double tolerance = 1e-10;  // of residuals and gap
  // Largest residuals and gap of a solution that is accepted where rounding stops the progress.
  double acceptable = 1e-7;
  // Largest error of a certificate of infeasibility in its equations. With an error of that size it
  // still proves that no solution smaller than the inverse of this number exists.
  double infeasible_tolerance = 1e-10;
  int max_iterations = 100;
};

// The solution, or a certificate that there is none, depending on `status`.
// Optimal: x with the slack s = h - G x, and the solution y, z of the dual program, which maximises
// -b'y - h'z subject to A'y + G'z + c = 0 and z in the cone (the cone is its own dual).
// Primal infeasible: z in the cone with A'y + G'z = 0 and b'y + h'z = -1; x and s are zero.
// Dual infeasible: A x = 0, s = -G x in the cone and c'x = -1; y and z are zero.
struct ConicSolution {
  ConicStatus status = ConicStatus::limit;
  Eigen::VectorXd x;          // n
  Eigen::VectorXd y;          // p
  Eigen::VectorXd z;          // m
  Eigen::VectorXd s;          // m
  double primal_value = 0.0;  // c'x
  double dual_value = 0.0;    // -b'y - h'z
  double primal_residual =
      0.0;                     // largest of A x - b and G x + s - h; of A x and G x + s (dual inf.)
  double dual_residual = 0.0;  // largest of A'y + G'z + c; of A'y + G'z (primal infeasible)
  double gap = 0.0;            // s'z
  int iterations = 0;
};

// Solves the program by a primal-dual interior point method on the homogeneous self-dual embedding,
// with Nesterov-Todd scaling and Mehrotra's predictor-corrector steps. Rows of A may be linearly
// dependent, and so may columns of [A; G]. Deterministic. Source: Domahidi, Chu and Boyd, "ECOS: An
// SOCP solver for embedded systems", 2013, sections II and III; Andersen, Dahl and Vandenberghe,
// "Interior-point methods for large-scale cone programming", 2011.
//
// Throws InputError for shapes that do not fit, a value that is not finite, a second-order cone
// without rows, or an option that is not positive. Infeasibility is a status, not an error.
ConicSolution solve(const ConicProgram& program, const ConicOptions& options = {});

}  // namespace prehend
