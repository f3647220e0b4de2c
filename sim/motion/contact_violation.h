// How far velocities and impulses are from the law of contact.
#pragma once

#include <vector>

#include "sim/motion/contact_problem.h"
#include "sim/motion/smoothed_contacts.h"

namespace prehend {

// The largest velocity that occurs, to which violations are relative.
double velocity_scale(const ContactProblem& problem, const Eigen::VectorXd& v);

// The violation of all conditions and of momentum, relative to the velocities that occur.
double violation_of(const ContactProblem& problem, const std::vector<MassFactor>& masses,
                    const std::vector<double>& inertias, const Eigen::VectorXd& v,
                    const std::vector<ConeVector>& impulses);

// How far the velocities and impulses are from the law, as ContactSolution::violation.
double contact_violation(const ContactProblem& problem, const Eigen::VectorXd& velocity,
                         const std::vector<Eigen::Vector4d>& impulses);

}  // namespace prehend
