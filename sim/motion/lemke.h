// Linear complementarity problems by Lemke's pivoting method.
#pragma once

#include <Eigen/Core>

namespace prehend {

// How Lemke's method ended.
enum class LcpOutcome {
  solved,
  ray,       // the path went to infinity: for copositive matrices a proof that there is no solution
  too_long,  // more pivots than allowed
};

struct LcpSolution {
  LcpOutcome outcome = LcpOutcome::solved;
  Eigen::VectorXd z;  // n, >= 0; where the method did not solve: as far as it came
  int pivots = 0;
};

// Finds z with z >= 0, w = M z + q >= 0 and z . w = 0 (n x n, n).
//
// Lemke's method (Cottle, Pang and Stone 1992, The Linear Complementarity Problem, section 4.4)
// follows a path of basic solutions of w = M z + q + d z0 from z0 large to z0 = 0. Where the ratio
// test has ties, as symmetric contacts make them, the lexicographic rule decides (section 4.9): the
// path then visits no basis twice, so the method ends, and which solution it finds does not depend
// on rounding that differs between machines with the same arithmetic. For copositive-plus matrices,
// and for those of contacts with friction whose gaps are open (Anitescu and Potra 1997,
// theorem 3.2), it ends with a solution.
// At most `max_pivots` (>= 1) are made.
LcpSolution solve_lcp(const Eigen::MatrixXd& M, const Eigen::VectorXd& q, int max_pivots = 10000);

}  // namespace prehend
