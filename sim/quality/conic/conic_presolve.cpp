#include "sim/quality/conic/conic_presolve.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

namespace prehend {
namespace {

// Ruiz' iteration halves the logarithm of the largest entries in each round, so that few suffice.
constexpr int kRuizRounds = 8;
// A pivot of the QR factors below this part of the largest is rounding: its row is dependent.
constexpr double kDependent = 1e-13;
// A dependent equation is consistent if its error is at most this part of b.
constexpr double kInconsistent = 1e-10;

// The power of two nearest to 1 / sqrt(size); 1 for 0.
double inverse_root(double size) {
  return size > 0.0 ? std::exp2(-std::round(std::log2(size) / 2.0)) : 1.0;
}

// The power of two nearest to size; 1 for 0.
double power_of_two(double size) {
  return size > 0.0 ? std::exp2(std::round(std::log2(size))) : 1.0;
}

using PivotedQr = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;

// QR factors with column pivoting, whose rank is the number of pivots above the threshold.
PivotedQr factors_of(const Eigen::MatrixXd& m) {
  PivotedQr qr(m.rows(), m.cols());
  qr.setThreshold(kDependent);
  qr.compute(m);
  return qr;
}

// The square Q. Its first `rank` columns span the range of the matrix, the others its orthogonal
// complement.
Eigen::MatrixXd full_q(const PivotedQr& qr) {
  return qr.householderQ() * Eigen::MatrixXd::Identity(qr.rows(), qr.rows());
}

}  // namespace

Equilibration::Equilibration(const ConicProgram& program)
    : scaled_(program),
      columns_(Eigen::VectorXd::Ones(program.c.size())),
      rows_of_A_(Eigen::VectorXd::Ones(program.b.size())),
      rows_of_G_(Eigen::VectorXd::Ones(program.h.size())) {
  for (int round = 0; round < kRuizRounds; ++round) scale_once();
  scaled_.b = rows_of_A_.cwiseProduct(scaled_.b);
  scaled_.h = rows_of_G_.cwiseProduct(scaled_.h);
  scaled_.c = columns_.cwiseProduct(scaled_.c);
  right_ = power_of_two(std::max(largest_entry(scaled_.b), largest_entry(scaled_.h)));
  objective_ = power_of_two(largest_entry(scaled_.c));
  scaled_.b /= right_;
  scaled_.h /= right_;
  scaled_.c /= objective_;
}

// One round: divides each row and column by the square root of its largest entry. Row and column
// share the correction of an entry, hence the root.
void Equilibration::scale_once() {
  Eigen::VectorXd column(scaled_.c.size());
  Eigen::VectorXd row_of_A(scaled_.b.size());
  Eigen::VectorXd row_of_G(scaled_.h.size());
  for (Eigen::Index j = 0; j < column.size(); ++j) {
    column[j] =
        inverse_root(std::max(largest_entry(scaled_.A.col(j)), largest_entry(scaled_.G.col(j))));
  }
  for (Eigen::Index i = 0; i < row_of_A.size(); ++i)
    row_of_A[i] = inverse_root(largest_entry(scaled_.A.row(i)));
  for (Eigen::Index i = 0; i < row_of_G.size(); ++i)
    row_of_G[i] = inverse_root(largest_entry(scaled_.G.row(i)));
  for_each_second_order(scaled_.cone, [&](Eigen::Index first, Eigen::Index rows) {
    row_of_G.segment(first, rows)
        .setConstant(inverse_root(largest_entry(scaled_.G.middleRows(first, rows))));
  });
  scaled_.A = row_of_A.asDiagonal() * scaled_.A * column.asDiagonal();
  scaled_.G = row_of_G.asDiagonal() * scaled_.G * column.asDiagonal();
  columns_ = columns_.cwiseProduct(column);
  rows_of_A_ = rows_of_A_.cwiseProduct(row_of_A);
  rows_of_G_ = rows_of_G_.cwiseProduct(row_of_G);
}

// With D the column factors and R those of the rows, the scaled program has G' = R G D, h' = R h /
// right and c' = D c / objective. Its solution x' gives x = right D x' and s = right R^-1 s'; its
// multipliers give y and z = objective R (y', z'). For A and b the same holds with the factors of
// their rows.
void Equilibration::restore(ConicSolution& solution) const {
  solution.x = right_ * columns_.cwiseProduct(solution.x);
  solution.s = right_ * solution.s.cwiseQuotient(rows_of_G_);
  solution.y = objective_ * rows_of_A_.cwiseProduct(solution.y);
  solution.z = objective_ * rows_of_G_.cwiseProduct(solution.z);
}

Reduction::Reduction(const ConicProgram& program) : reduced_(program), rows_(program.b.size()) {
  drop_rows(program);
  if (!decided_) drop_directions(program);
}

// Leaves out dependent rows of A if b agrees with them. Let e be b less its projection on the range
// of A: A'e = 0 and b'e = |e|^2. If e is not zero, A x = b has no solution, and y = -e / |e|^2 is
// the certificate (A'y = 0, b'y = -1). The projection is subtracted twice to remove its rounding.
void Reduction::drop_rows(const ConicProgram& program) {
  kept_ = Eigen::VectorXi::LinSpaced(rows_, 0, static_cast<int>(rows_) - 1);
  if (rows_ == 0) return;
  const Eigen::Index rank = largest_entry(program.A) > 0.0 ? factors_of(program.A).rank() : 0;
  if (rank == rows_) return;
  Eigen::VectorXd error = program.b;
  if (rank > 0) {
    const Eigen::MatrixXd range = full_q(factors_of(program.A)).leftCols(rank);
    error -= range * (range.transpose() * error);
    error -= range * (range.transpose() * error);
  }
  if (error.norm() > kInconsistent * program.b.norm()) {
    decide(program, ConicStatus::primal_infeasible);
    solution_.y = -error / error.dot(program.b);
    return;
  }
  kept_.conservativeResize(rank);
  if (rank > 0) {
    // The pivots of the QR factors of A' choose a set of independent rows.
    kept_ = factors_of(program.A.transpose()).colsPermutation().indices().head(rank);
    std::sort(kept_.begin(), kept_.end());
  }
  reduced_.A = program.A(kept_, Eigen::all).eval();
  reduced_.b = program.b(kept_).eval();
}

// Leaves out directions of x that change neither A x nor G x. If c has a component along one of
// them, c'x has no lower bound. Else the program is written in coordinates of the row space of
// [A; G], the orthogonal complement of these directions.
void Reduction::drop_directions(const ConicProgram& program) {
  const Eigen::Index n = program.c.size();
  Eigen::MatrixXd all(n, reduced_.A.rows() + reduced_.G.rows());
  all << reduced_.A.transpose(), reduced_.G.transpose();
  const Eigen::Index rank = largest_entry(all) > 0.0 ? factors_of(all).rank() : 0;
  if (rank == n) return;
  Eigen::MatrixXd basis = Eigen::MatrixXd::Identity(n, n);
  if (rank > 0) basis = full_q(factors_of(all));
  const auto unseen = basis.rightCols(n - rank);
  const Eigen::VectorXd along = unseen * (unseen.transpose() * program.c);
  if (along.norm() > kInconsistent * program.c.norm()) {
    decide(program, ConicStatus::dual_infeasible);
    solution_.x = -along / along.dot(program.c);
    return;
  }
  seen_ = basis.leftCols(rank);
  reduced_.A = (reduced_.A * seen_).eval();
  reduced_.G = (reduced_.G * seen_).eval();
  reduced_.c = (seen_.transpose() * reduced_.c).eval();
}

void Reduction::decide(const ConicProgram& program, ConicStatus status) {
  decided_ = true;
  solution_.status = status;
  solution_.x = Eigen::VectorXd::Zero(program.c.size());
  solution_.y = Eigen::VectorXd::Zero(program.b.size());
  solution_.z = Eigen::VectorXd::Zero(program.h.size());
  solution_.s = Eigen::VectorXd::Zero(program.h.size());
}

// Directions left out have the component 0, rows left out the multiplier 0.
void Reduction::restore(ConicSolution& solution) const {
  if (seen_.rows() > 0) solution.x = (seen_ * solution.x).eval();
  const Eigen::VectorXd kept = solution.y;
  solution.y = Eigen::VectorXd::Zero(rows_);
  solution.y(kept_) = kept;
}

}  // namespace prehend
