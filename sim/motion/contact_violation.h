// How far velocities and impulses are from the law of contact.
#pragma once

#include <vector>

#include "sim/motion/contact_problem.h"
#include "sim/motion/smoothed_contacts.h"

namespace prehend {

// The largest velocity that occurs without impulses of contacts; 1 where nothing moves.
double free_velocity_scale(const ContactProblem& problem);

// The violation of all conditions and of momentum, relative to the velocities that occur. `scale`:
// free_velocity_scale.
double violation_of(const ContactProblem& problem, const std::vector<MassFactor>& masses,
                    const std::vector<double>& inertias, double scale, const Eigen::VectorXd& v,
                    const std::vector<ConeVector>& impulses);

// How far the velocities and impulses are from the law, as ContactSolution::violation.
double contact_violation(const ContactProblem& problem, const Eigen::VectorXd& velocity,
                         const std::vector<Eigen::Vector4d>& impulses);

}  // namespace prehend
