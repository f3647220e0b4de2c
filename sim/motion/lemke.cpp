#include "sim/motion/lemke.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/LU>

namespace prehend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Pivots after which the tableau is made anew.
constexpr int kRefreshed = 100;

// Entries of a column below this part of its largest do not limit a step. What limits it at ratios
// within this part of each other counts as a tie.
constexpr double kTolerance = 1e-11;

// The columns of the tableau: q, then w, z and z0. The columns of w are the inverse of the basis,
// which the lexicographic rule compares.
class Tableau {
 public:
  Tableau(const MatrixXd& M, const VectorXd& q) : size_(q.size()), rows_(size_, 2 * size_ + 2) {
    rows_.col(0) = q;
    rows_.middleCols(1, size_).setIdentity();
    rows_.middleCols(1 + size_, size_) = -M;
    rows_.col(artificial()).setConstant(-1.0);
    basis_.resize(static_cast<std::size_t>(size_));
    for (Index i = 0; i < size_; ++i) basic(i) = 1 + i;
  }

  Index artificial() const { return 2 * size_ + 1; }
  Index complement(Index column) const { return column <= size_ ? column + size_ : column - size_; }
  Index& basic(Index row) { return basis_[static_cast<std::size_t>(row)]; }
  Index basic(Index row) const { return basis_[static_cast<std::size_t>(row)]; }

  // The row of the most negative q, the last of those that are equal: with it z0 enters.
  Index first_row() const {
    Index least = 0;
    for (Index i = 1; i < size_; ++i) {
      if (rows_(i, 0) <= rows_(least, 0)) least = i;
    }
    return least;
  }

  // The row whose variable is first to become zero as the column enters; -1: none does.
  Index leaving_row(Index column) const {
    const double least = kTolerance * rows_.col(column).cwiseAbs().maxCoeff();
    Index best = -1;
    for (Index i = 0; i < size_; ++i) {
      if (!(rows_(i, column) > least)) continue;
      if (best < 0 || comes_before(i, best, column)) best = i;
    }
    return best;
  }

  void pivot(Index row, Index column) {
    rows_.row(row) /= rows_(row, column);
    factors_ = rows_.col(column);
    factors_[row] = 0.0;
    pivot_row_ = rows_.row(row);
    rows_.noalias() -= factors_ * pivot_row_;
    basic(row) = column;
  }

  // The tableau of the basis from the problem itself: pivots collect rounding.
  void refresh(const MatrixXd& M, const VectorXd& q) {
    MatrixXd columns(size_, size_);
    for (Index i = 0; i < size_; ++i) columns.col(i) = column_of(M, basic(i));
    const Eigen::PartialPivLU<MatrixXd> factor(columns);
    rows_.col(0) = factor.solve(q);
    rows_.middleCols(1, size_) = factor.inverse();
    rows_.middleCols(1 + size_, size_) = -(rows_.middleCols(1, size_) * M);
    rows_.col(artificial()) = -rows_.middleCols(1, size_).rowwise().sum();
  }

  VectorXd solution() const {
    VectorXd z = VectorXd::Zero(size_);
    for (Index i = 0; i < size_; ++i) {
      const Index column = basic(i);
      if (column > size_ && column < artificial())
        z[column - size_ - 1] = std::max(rows_(i, 0), 0.0);
    }
    return z;
  }

 private:
  VectorXd column_of(const MatrixXd& M, Index column) const {
    if (column == artificial()) return VectorXd::Constant(size_, -1.0);
    if (column > size_) return -M.col(column - size_ - 1);
    return VectorXd::Unit(size_, column - 1);
  }

  // The lexicographic ratio test: row a against row b, by q and then by the inverse of the basis.
  // Among ties of q, z0 leaves: that ends the path.
  bool comes_before(Index a, Index b, Index column) const {
    for (Index k = 0; k <= size_; ++k) {
      const double of_a = rows_(a, k) / rows_(a, column);
      const double of_b = rows_(b, k) / rows_(b, column);
      const double size = std::max(std::abs(of_a), std::abs(of_b));
      if (std::abs(of_a - of_b) > kTolerance * std::max(size, 1e-300)) return of_a < of_b;
      if (k == 0 && basic(b) == artificial()) return false;
      if (k == 0 && basic(a) == artificial()) return true;
    }
    return false;
  }

  Index size_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows_;
  std::vector<Index> basis_;
  VectorXd factors_;
  Eigen::RowVectorXd pivot_row_;
};

// The basic variables that are z, solved for once more: pivots have collected rounding.
VectorXd polished(const MatrixXd& M, const VectorXd& q, const VectorXd& z) {
  std::vector<Index> active;
  for (Index i = 0; i < z.size(); ++i) {
    if (z[i] > 0.0) active.push_back(i);
  }
  if (active.empty()) return z;
  const MatrixXd part = M(active, active);
  const VectorXd found = part.partialPivLu().solve(-q(active));
  if (!found.allFinite() || found.minCoeff() < 0.0) return z;
  VectorXd result = VectorXd::Zero(z.size());
  result(active) = found;
  const auto worst = [&](const VectorXd& at) {
    const VectorXd w = M * at + q;
    return at.cwiseMin(w).cwiseAbs().maxCoeff();
  };
  return worst(result) <= worst(z) ? result : z;
}

}  // namespace

LcpSolution solve_lcp(const MatrixXd& M, const VectorXd& q, int max_pivots) {
  LcpSolution solution;
  solution.z = VectorXd::Zero(q.size());
  if (q.size() == 0 || q.minCoeff() >= 0.0) return solution;
  Tableau tableau(M, q);
  Index row = tableau.first_row();
  Index entering = tableau.artificial();
  while (true) {
    const Index leaving = tableau.basic(row);
    tableau.pivot(row, entering);
    ++solution.pivots;
    if (leaving == tableau.artificial()) break;
    if (solution.pivots >= max_pivots) {
      solution.outcome = LcpOutcome::too_long;
      break;
    }
    if (solution.pivots % kRefreshed == 0) tableau.refresh(M, q);
    entering = tableau.complement(leaving);
    row = tableau.leaving_row(entering);
    if (row < 0) {
      solution.outcome = LcpOutcome::ray;
      break;
    }
  }
  solution.z = tableau.solution();
  if (solution.outcome == LcpOutcome::solved) solution.z = polished(M, q, solution.z);
  return solution;
}

}  // namespace prehend
