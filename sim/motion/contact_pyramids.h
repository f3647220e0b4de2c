// The impulses of a step with friction pyramids instead of cones, by pivoting.
#pragma once

#include "sim/motion/contact_problem.h"

namespace prehend {

// Solves the problem with pyramids: velocities v and impulses p with
//
//   M (v - v_free) = J' p,   0 <= p_n  |_ w_n >= 0,
//   p_t = sum of beta_k d_k,   0 <= beta_k  |_ d_k . w_t + sigma >= 0,
//   0 <= sigma  |_ mu p_n - sum of beta_k >= 0
//
// a linear complementarity problem, exactly (Stewart and Trinkle 1996; Anitescu and Potra 1997).
// Resistance to spin adds an edge along either direction of spin. Joints keep their intervals.
// `violation` states what rounding left, relative to the velocities that occur, of the law with
// pyramids. Its time grows with the third power of the number of contacts. Deterministic.
//
// `edges` (>= 3) of the pyramid around the normal of a contact lie on the cone, so that friction is
// weaker by up to 1 - cos(pi / edges) between them: 7.6 % for 8.
ContactSolution solve_with_pyramids(const ContactProblem& problem, int edges = 8);

}  // namespace prehend
