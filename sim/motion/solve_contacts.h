// The velocities and impulses of one time step.
#pragma once

#include "sim/motion/contact_problem.h"

namespace prehend {

// Solves the problem as the options say: with all corrections, or where that has no solution, as
// impulses without bounds show, with none. Deterministic.
ContactSolution solve_contacts(const ContactProblem& problem,
                               const ContactSolverOptions& options = {},
                               const WarmStart& warm = {});

}  // namespace prehend
