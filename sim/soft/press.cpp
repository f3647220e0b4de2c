#include "sim/soft/press.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Cholesky>

namespace prehend {
namespace {

// Of the largest gap or force: what rounding leaves of 0.
constexpr double kRounding = 1e-10;
// Block pivots without progress before single ones take over.
constexpr int kPatience = 10;
// Pivots in all, for each node: a bound in case rounding makes them go round in circles.
constexpr std::size_t kMostPivots = 20;

// The compliance among the nodes in contact, factored, and those nodes.
struct Touching {
  explicit Touching(const PressProblem& problem, const std::vector<bool>& in_contact) {
    for (std::size_t i = 0; i < in_contact.size(); ++i) {
      if (in_contact[i]) nodes.push_back(static_cast<Eigen::Index>(i));
    }
    factors.compute(problem.compliance(nodes, nodes));
  }

  std::vector<Eigen::Index> nodes;
  Eigen::LLT<Eigen::MatrixXd> factors;
};

NodeForces forces_of(const PressProblem& problem, const Touching& touching,
                     const Eigen::VectorXd& force, double approach) {
  NodeForces result;
  result.approach = approach;
  result.force = Eigen::VectorXd::Zero(problem.gap.size());
  result.force(touching.nodes) = force;
  result.gap = problem.gap - approach * problem.weight;
  if (!touching.nodes.empty()) {
    result.gap += problem.compliance(Eigen::all, touching.nodes) * force;
  }
  result.gap(touching.nodes).setZero();
  result.load = problem.weight.dot(result.force);
  return result;
}

// Nodes that pull or lie inside the rigid surface.
struct Violations {
  int count = 0;
  Eigen::Index last = -1;
};

Violations find_violations(const NodeForces& forces, const PressProblem& problem,
                           std::vector<bool>* pivoted) {
  const double least_force = kRounding * forces.force.cwiseAbs().maxCoeff();
  const double least_gap =
      kRounding * std::max(problem.gap.cwiseAbs().maxCoeff(), std::abs(forces.approach));
  Violations violations;
  for (Eigen::Index i = 0; i < forces.gap.size(); ++i) {
    if (forces.force[i] >= -least_force && forces.gap[i] >= -least_gap) continue;
    ++violations.count;
    violations.last = i;
    if (pivoted != nullptr) {
      (*pivoted)[static_cast<std::size_t>(i)] = !(*pivoted)[static_cast<std::size_t>(i)];
    }
  }
  return violations;
}

NodeForces without_rounding(NodeForces forces) {
  forces.force = forces.force.cwiseMax(0.0);
  return forces;
}

// Counts pivots in blocks: whether the number of violations has fallen in the last kPatience ones.
class BlockPivots {
 public:
  bool goes_on(int violations) {
    if (violations < fewest_) {
      fewest_ = violations;
      patience_ = kPatience;
    } else {
      --patience_;
    }
    return patience_ > 0;
  }

 private:
  int fewest_ = std::numeric_limits<int>::max();
  int patience_ = kPatience;
};

// The nodes that touch in an elastic foundation of about the same stiffness, at the approach.
std::vector<bool> within(const PressProblem& problem, double approach) {
  std::vector<bool> in_contact(static_cast<std::size_t>(problem.gap.size()));
  for (std::size_t i = 0; i < in_contact.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    in_contact[i] = problem.gap[at] < problem.weight[at] * approach;
  }
  return in_contact;
}

// The approach at which an elastic foundation bears the load: as stiff as all nodes together are
// under a uniform pressure.
double foundation_approach(const PressProblem& problem, double load) {
  const Eigen::Index n = problem.gap.size();
  const double stiffness = static_cast<double>(n) / problem.compliance.sum();
  std::vector<double> first(static_cast<std::size_t>(n));  // approach at which each node touches
  for (Eigen::Index i = 0; i < n; ++i) {
    first[static_cast<std::size_t>(i)] = problem.gap[i] / problem.weight[i];
  }
  std::ranges::sort(first);
  double sum = 0.0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    sum += first[k];
    const double count = static_cast<double>(k) + 1.0;
    const double approach = (load / stiffness + sum) / count;
    if (k + 1 == first.size() || approach <= first[k + 1]) return approach;
  }
  return 0.0;
}

}  // namespace

NodeForces press_by(const PressProblem& problem, double approach) {
  std::vector<bool> in_contact = within(problem, approach);
  BlockPivots progress;
  bool in_blocks = true;
  std::size_t left = kMostPivots * in_contact.size();
  while (true) {
    const Touching touching(problem, in_contact);
    const Eigen::VectorXd wanted = approach * problem.weight - problem.gap;
    const Eigen::VectorXd force = touching.nodes.empty()
                                      ? Eigen::VectorXd()
                                      : touching.factors.solve(wanted(touching.nodes)).eval();
    const NodeForces forces = forces_of(problem, touching, force, approach);
    std::vector<bool> pivoted = in_contact;
    const Violations violations = find_violations(forces, problem, &pivoted);
    if (violations.count == 0 || left-- == 0) return without_rounding(forces);
    in_blocks = in_blocks && progress.goes_on(violations.count);
    if (in_blocks) {
      in_contact = std::move(pivoted);
    } else {
      // Murty's rule: always the last one. It ends for every positive definite matrix, up to
      // rounding, for which the pivots are counted.
      const auto last = static_cast<std::size_t>(violations.last);
      in_contact[last] = !in_contact[last];
    }
  }
}

namespace {

// Pivots in blocks with the approach as one more unknown; none where they go round in circles.
std::optional<NodeForces> pivot_with(const PressProblem& problem, double load) {
  std::vector<bool> in_contact = within(problem, foundation_approach(problem, load));
  BlockPivots progress;
  while (true) {
    const Touching touching(problem, in_contact);
    if (touching.nodes.empty()) return std::nullopt;
    // p = A^-1 (d w - g) with w . p = load gives the approach d.
    const Eigen::VectorXd weight = problem.weight(touching.nodes);
    const Eigen::VectorXd per_approach = touching.factors.solve(weight);
    const Eigen::VectorXd by_gap = touching.factors.solve(problem.gap(touching.nodes).eval());
    const double approach = (load + weight.dot(by_gap)) / weight.dot(per_approach);
    const NodeForces forces =
        forces_of(problem, touching, approach * per_approach - by_gap, approach);
    const Violations violations = find_violations(forces, problem, &in_contact);
    if (violations.count == 0) return without_rounding(forces);
    if (!progress.goes_on(violations.count)) return std::nullopt;
  }
}

// The load grows with the approach, so that bisection always finds it.
NodeForces bisect_load(const PressProblem& problem, double load, double farthest) {
  double lower = 0.0;
  double upper = farthest;
  NodeForces best = press_by(problem, upper);
  if (best.load <= load) return best;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings && upper - lower > kRounding * farthest; ++i) {
    const double middle = 0.5 * (lower + upper);
    NodeForces forces = press_by(problem, middle);
    (forces.load > load ? upper : lower) = middle;
    best = std::move(forces);
  }
  return best;
}

}  // namespace

NodeForces press_with(const PressProblem& problem, double load, double farthest) {
  assert(load > 0.0);
  if (problem.gap.size() == 0) return {};
  if (auto forces = pivot_with(problem, load)) {
    return forces->approach <= farthest ? *std::move(forces) : press_by(problem, farthest);
  }
  return bisect_load(problem, load, farthest);
}

}  // namespace prehend
