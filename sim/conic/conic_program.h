// Linear and second-order cone programs, small and dense.
#pragma once

#include <Eigen/Core>

#include "sim/conic/cone.h"

namespace prehend {

// Minimise c'x subject to A x = b and h - G x in the cone. A may have no rows, and so may G.
struct ConicProgram {
  Eigen::VectorXd c;  // n
  Eigen::MatrixXd A;  // p x n
  Eigen::VectorXd b;  // p
  Eigen::MatrixXd G;  // m x n
  Eigen::VectorXd h;  // m
  ConeSizes cone;     // of m rows
};

enum class ConicStatus {
  optimal,
  primal_infeasible,  // proved: no x meets the constraints
  dual_infeasible,    // proved: c'x has no lower bound, if any x meets the constraints
  limit,              // iterations used up, or rounding stalls; the best iterate stands, be it a
                      // solution or y and z of a certificate that is not good enough
};

// Tolerances are relative to the largest of c and of b and h, with rows and columns equilibrated.
struct ConicOptions {
  double tolerance = 1e-10;  // of residuals and gap
  // Largest residuals and gap of a solution that is accepted where rounding stops the progress.
  double acceptable = 1e-7;
  // Of a certificate's equations. No solution smaller than its inverse exists then.
  double infeasible_tolerance = 1e-10;
  int max_iterations = 100;
};

// Optimal: s = h - G x, the dual maximises -b'y - h'z with A'y + G'z + c = 0 and z in the cone,
// which is its own dual. Primal infeasible: z in the cone, A'y + G'z = 0, b'y + h'z = -1; x and s
// are zero. Dual infeasible: A x = 0, s = -G x in the cone, c'x = -1; y and z are zero.
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

// Primal-dual interior point method on the homogeneous self-dual embedding, with Nesterov-Todd
// scaling and Mehrotra's corrector. Rows of A and columns of [A; G] may depend on each other. No
// randomness. Source: Domahidi, Chu and Boyd, "ECOS: An SOCP solver for embedded systems", 2013,
// sections II and III; Andersen, Dahl and Vandenberghe, "Interior-point methods for large-scale
// cone programming", 2011.
//
// Throws InputError for shapes that do not fit, a value that is not finite, a
// second-order cone without rows, or an option that is not positive.
ConicSolution solve(const ConicProgram& program, const ConicOptions& options = {});

}  // namespace prehend
