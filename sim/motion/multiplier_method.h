// The impulses of a step on the exact friction cones.
#pragma once

#include "sim/motion/contact_problem.h"

namespace prehend {

// Solves the problem by the proximal method of multipliers on the velocities: with mu |w_t| held
// from the round before, it is a convex problem (Anitescu 2006; Cadoux 2009 for the fixed point),
// whose smoothed form has a Newton step of the size of the velocities, whatever the number of
// contacts. Of the options those of cones. Deterministic.
ContactSolution solve_with_multipliers(const ContactProblem& problem,
                                       const ContactSolverOptions& options = {},
                                       const WarmStart& warm = {});

}  // namespace prehend
