#include "sim/motion/contact_pyramids.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "sim/motion/lemke.h"
#include "sim/motion/smoothed_contacts.h"

namespace prehend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// What rounding may leave of the law in a problem that pivoting solved.
constexpr double kExact = 1e-6;

// The directions d_k of a contact with so many tangential rows, as columns.
MatrixXd pyramid_edges(Index tangents, int edges) {
  MatrixXd directions = MatrixXd::Zero(tangents, edges + (tangents > 2 ? 2 : 0));
  for (int k = 0; k < edges; ++k) {
    const double angle = 2.0 * std::acos(-1.0) * k / edges;
    directions(0, k) = std::cos(angle);
    directions(1, k) = std::sin(angle);
  }
  if (tangents > 2) {
    directions(2, edges) = 1.0;
    directions(2, edges + 1) = -1.0;
  }
  return directions;
}

// All conditions of a problem row by row, in impulses p^ = p / s and velocities w^ = s w with s the
// root of the inertia that a condition feels, so that numbers of all contacts are of one size:
// w^ = delassus p^ + free.
struct ConditionRows {
  std::vector<MassFactor> masses;
  std::vector<Index> first;  // row of each condition
  VectorXd scale;            // s of each row
  MatrixXd whitened;         // L^-1 J' s, with L L' the mass matrix
  MatrixXd delassus;
  VectorXd free;
};

ConditionRows rows_of(const ContactProblem& problem) {
  ConditionRows rows;
  rows.masses = mass_factors(problem);
  const std::vector<double> inertias = felt_inertias(problem, rows.masses);
  Index count = 0;
  for (const ContactCondition& condition : problem.contacts) {
    rows.first.push_back(count);
    count += condition.rows;
  }
  rows.scale.resize(count);
  rows.free.resize(count);
  rows.whitened.setZero(problem.free.size(), count);
  VectorXd compliance = VectorXd::Zero(count);
  for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
    const ContactCondition& condition = problem.contacts[i];
    const Index size = condition.rows;
    const double scale = std::sqrt(inertias[i]);
    rows.scale.segment(rows.first[i], size).setConstant(scale);
    rows.free.segment(rows.first[i], size) =
        scale * relative_velocity(condition, problem.free).head(size);
    compliance.segment(rows.first[i], size).setConstant(scale * scale * condition.compliance);
    for (const JacobianBlock& block : condition.blocks) {
      rows.whitened.block(block.first, rows.first[i], block.transposed.rows(), size) =
          scale * block.transposed.leftCols(size);
    }
  }
  for (const MassFactor& mass : rows.masses) {
    auto part = rows.whitened.middleRows(mass.first, mass.factor.cols());
    mass.factor.matrixL().solveInPlace(part);
  }
  rows.delassus = rows.whitened.transpose() * rows.whitened;
  rows.delassus.diagonal() += compliance;
  return rows;
}

// Impulses as functions of the variables of a linear complementarity problem: p^ = from_x x + base
// of all rows but those that are `bilateral`, where w^ = 0 whatever the impulse.
class PyramidVariables {
 public:
  PyramidVariables(const ContactProblem& problem, const ConditionRows& rows, int edges)
      : edges_(edges), base(VectorXd::Zero(rows.scale.size())) {
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
      const ContactCondition& condition = problem.contacts[i];
      if (condition.rows == 1) {
        add_joint(condition, rows.first[i], rows.scale[rows.first[i]]);
      } else {
        add_contact(condition, rows.first[i], condition.rows - 1);
      }
    }
  }

  // x |_ from_x' w^ + coupling x + constant.
  MatrixXd from_x() const { return dense(impulses_, base.size()); }
  MatrixXd coupling() const { return dense(couplings_, count_); }
  VectorXd constant() const {
    VectorXd result = VectorXd::Zero(count_);
    for (const auto& [variable, value] : constants_) result[variable] = value;
    return result;
  }

 private:
  struct Entry {
    Index row;
    Index column;
    double value;
  };

  void add_contact(const ContactCondition& condition, Index row, Index tangents) {
    const MatrixXd directions = pyramid_edges(tangents, edges_);
    const Index normal = count_;
    const Index sigma = normal + 1 + directions.cols();
    impulses_.push_back({row, normal, 1.0});
    couplings_.push_back({sigma, normal, condition.friction});
    for (Index k = 0; k < directions.cols(); ++k) {
      const Index beta = normal + 1 + k;
      for (Index t = 0; t < tangents; ++t) {
        if (directions(t, k) != 0.0) impulses_.push_back({row + 1 + t, beta, directions(t, k)});
      }
      couplings_.push_back({beta, sigma, 1.0});
      couplings_.push_back({sigma, beta, -1.0});
    }
    count_ = sigma + 1;
  }

  void add_joint(const ContactCondition& condition, Index row, double scale) {
    const bool below = std::isfinite(condition.lower);
    const bool above = std::isfinite(condition.upper);
    if (!below && !above) {
      bilateral.push_back(row);
      return;
    }
    base[row] = (below ? condition.lower : condition.upper) / scale;
    if (condition.lower == condition.upper) return;
    impulses_.push_back({row, count_, below ? 1.0 : -1.0});
    if (below && above) {
      couplings_.push_back({count_, count_ + 1, 1.0});
      couplings_.push_back({count_ + 1, count_, -1.0});
      constants_.emplace_back(count_ + 1, (condition.upper - condition.lower) / scale);
      ++count_;
    }
    ++count_;
  }

  MatrixXd dense(const std::vector<Entry>& entries, Index rows) const {
    MatrixXd result = MatrixXd::Zero(rows, count_);
    for (const Entry& entry : entries) result(entry.row, entry.column) = entry.value;
    return result;
  }

  int edges_;
  Index count_ = 0;
  std::vector<Entry> impulses_;
  std::vector<Entry> couplings_;
  std::vector<std::pair<Index, double>> constants_;

 public:
  VectorXd base;
  std::vector<Index> bilateral;
};

// What the impulses of bilateral rows do to the others: p_F = gain (delassus_F p + free_F).
MatrixXd bilateral_gain(const ConditionRows& rows, const std::vector<Index>& bilateral) {
  MatrixXd gain = MatrixXd::Zero(rows.scale.size(), rows.scale.size());
  if (bilateral.empty()) return gain;
  const auto size = static_cast<Index>(bilateral.size());
  const MatrixXd inner = rows.delassus(bilateral, bilateral);
  gain(bilateral, bilateral) = -inner.fullPivLu().solve(MatrixXd::Identity(size, size));
  return gain;
}

}  // namespace

ContactSolution solve_with_pyramids(const ContactProblem& problem, int edges) {
  const ConditionRows rows = rows_of(problem);
  const PyramidVariables variables(problem, rows, edges);
  const MatrixXd gain = bilateral_gain(rows, variables.bilateral);
  const MatrixXd response = rows.delassus + rows.delassus * gain * rows.delassus;
  const VectorXd free = rows.free + rows.delassus * gain * rows.free;
  const MatrixXd from_x = variables.from_x();
  const MatrixXd M = from_x.transpose() * response * from_x + variables.coupling();
  const VectorXd q = from_x.transpose() * (response * variables.base + free) + variables.constant();
  const LcpSolution found = solve_lcp(M, q);

  VectorXd p = from_x * found.z + variables.base;
  p += gain * (rows.delassus * p + rows.free);
  VectorXd change = rows.whitened * p;
  for (const MassFactor& mass : rows.masses) {
    auto part = change.segment(mass.first, mass.factor.cols());
    mass.factor.matrixU().solveInPlace(part);
  }
  ContactSolution solution;
  solution.velocity = problem.free + change;
  solution.pivots = found.pivots;
  const double size = std::max(rows.free.lpNorm<Eigen::Infinity>(), 1e-300);
  solution.violation = found.z.cwiseMin(M * found.z + q).lpNorm<Eigen::Infinity>() / size;
  // However the pivots ended: near z0 = 0, rounding may hide the last one.
  solution.outcome =
      solution.violation <= kExact ? ContactOutcome::solved : ContactOutcome::not_converged;
  p = p.cwiseProduct(rows.scale);
  for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
    const Index count = problem.contacts[i].rows;
    solution.impulses.emplace_back(Eigen::Vector4d::Zero());
    solution.impulses.back().head(count) = p.segment(rows.first[i], count);
  }
  return solution;
}

}  // namespace prehend
