#include "sim/motion/contact_violation.h"

#include <algorithm>

#include <Eigen/Cholesky>

namespace prehend {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// How far a condition is from the law, as a velocity.
double violation_of(const ContactCondition& condition, double inertia, const VectorXd& v,
                    const ConeVector& impulse) {
  ConeVector w = relative_velocity(condition, v);
  // Steep cones are nearly half-spaces, from whose borders a velocity into the surface is not far.
  const double closing = condition.rows > 1 ? std::max(-w[0], 0.0) : 0.0;
  w[0] += condition.friction * slip_of(w) + condition.compliance * impulse[0];
  // Where a spring is softer than the inertia, it sets how large an impulse is.
  const double stiffness =
      condition.compliance > 0.0 ? std::min(inertia, 1.0 / condition.compliance) : inertia;
  const ConeVector projected = allowed_impulse(condition, impulse - stiffness * w).point;
  return std::max(closing, (impulse - projected).norm() / stiffness);
}

// How far the velocities are from what the impulses give.
double momentum_violation(const ContactProblem& problem, const std::vector<MassFactor>& masses,
                          const VectorXd& v, const std::vector<ConeVector>& impulses) {
  VectorXd push = VectorXd::Zero(v.size());
  for (std::size_t i = 0; i < impulses.size(); ++i) {
    for (const JacobianBlock& block : problem.contacts[i].blocks) {
      push.segment(block.first, block.transposed.rows()) +=
          block.transposed.lazyProduct(impulses[i]);
    }
  }
  double most = 0.0;
  for (const MassFactor& mass : masses) {
    const Index size = mass.factor.cols();
    const VectorXd change = mass.factor.solve(push.segment(mass.first, size));
    const VectorXd missing = (v - problem.free).segment(mass.first, size) - change;
    most = std::max(most, missing.lpNorm<Eigen::Infinity>());
  }
  return most;
}

}  // namespace

double free_velocity_scale(const ContactProblem& problem) {
  double scale = problem.free.lpNorm<Eigen::Infinity>();
  for (const ContactCondition& condition : problem.contacts) {
    if (condition.compliance > 0.0) continue;
    scale = std::max(scale, relative_velocity(condition, problem.free).lpNorm<Eigen::Infinity>());
  }
  return scale > 0.0 ? scale : 1.0;
}

double violation_of(const ContactProblem& problem, const std::vector<MassFactor>& masses,
                    const std::vector<double>& inertias, double scale, const VectorXd& v,
                    const std::vector<ConeVector>& impulses) {
  double most = momentum_violation(problem, masses, v, impulses);
  for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
    most = std::max(most, violation_of(problem.contacts[i], inertias[i], v, impulses[i]));
  }
  return most / std::max(scale, v.lpNorm<Eigen::Infinity>());
}

double contact_violation(const ContactProblem& problem, const VectorXd& velocity,
                         const std::vector<Eigen::Vector4d>& impulses) {
  const std::vector<MassFactor> masses = mass_factors(problem);
  return violation_of(problem, masses, felt_inertias(problem, masses), free_velocity_scale(problem),
                      velocity, impulses);
}

}  // namespace prehend
