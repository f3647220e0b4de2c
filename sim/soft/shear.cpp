#include "sim/soft/shear.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace prehend {
namespace {

// One node: minimises t' A t / 2 + b . t over the disc |t| <= limit.
class NodeShear {
 public:
  explicit NodeShear(const Eigen::Matrix2d& compliance) : axes_(compliance) {}

  Eigen::Vector2d best(const Eigen::Vector2d& b, double limit) const {
    const Eigen::Vector2d wanted = -(axes_.eigenvectors().transpose() * b);
    const Eigen::Vector2d values = axes_.eigenvalues();
    Eigen::Vector2d force = wanted.cwiseQuotient(values);
    if (force.norm() > limit) force = at_limit(wanted, values, limit);
    return axes_.eigenvectors() * force;
  }

 private:
  // On the circle t = (A + l)^-1 wanted for one l > 0: Newton's method on 1 / |t|, which is concave
  // and nearly linear in l (More and Sorensen 1983), never passes the root.
  static Eigen::Vector2d at_limit(const Eigen::Vector2d& wanted, const Eigen::Vector2d& values,
                                  double limit) {
    if (limit <= 0.0) return Eigen::Vector2d::Zero();
    double l = 0.0;
    Eigen::Vector2d force;
    constexpr int kSteps = 30;
    for (int i = 0; i < kSteps; ++i) {
      const Eigen::Vector2d stiff = values.array() + l;
      force = wanted.cwiseQuotient(stiff);
      const double size = force.norm();
      if (size <= limit * (1.0 + 1e-14)) break;
      const double slope = force.cwiseAbs2().cwiseQuotient(stiff).sum();
      l += (size - limit) / limit * size * size / slope;
    }
    return limit / force.norm() * force;
  }

  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes_;
};

}  // namespace

ShearForces shear(const ShearProblem& problem, const ShearOptions& options) {
  const Eigen::Index n = problem.limit.size();
  std::vector<NodeShear> nodes;
  nodes.reserve(static_cast<std::size_t>(n));
  for (Eigen::Index i = 0; i < n; ++i) {
    nodes.emplace_back(problem.compliance.block<2, 2>(2 * i, 2 * i));
  }
  ShearForces result;
  result.force = Eigen::VectorXd::Zero(2 * n);
  const double tolerance = options.tolerance * problem.limit.sum();
  // What each node would have slipped by: motion + compliance * force.
  Eigen::VectorXd slip = problem.motion;
  for (int sweep = 0; sweep < options.max_sweeps && !result.converged; ++sweep) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::Vector2d old = result.force.segment<2>(2 * i);
      const Eigen::Vector2d without =
          slip.segment<2>(2 * i) - problem.compliance.block<2, 2>(2 * i, 2 * i) * old;
      const Eigen::Vector2d change =
          nodes[static_cast<std::size_t>(i)].best(without, problem.limit[i]) - old;
      if (change.isZero(0.0)) continue;
      result.force.segment<2>(2 * i) += change;
      slip += problem.compliance.middleCols<2>(2 * i) * change;
      largest = std::max(largest, change.norm());
    }
    result.converged = largest <= tolerance;
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    // A node at its limit slides.
    result.sticking.push_back(result.force.segment<2>(2 * i).norm() <
                              (1.0 - 1e-9) * problem.limit[i]);
  }
  return result;
}

}  // namespace prehend
