#include "sim/motion/newton_matrix.h"

#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>

namespace prehend {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// From so many velocities on, the sparse factors are faster.
constexpr Index kDenseVelocities = 120;

VectorXd no_solution(Index size) {
  return VectorXd::Constant(size, std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

void NewtonMatrix::start(Index size) {
  size_ = size;
  is_sparse_ = size > kDenseVelocities;
  if (is_sparse_) {
    entries_.clear();
  } else {
    dense_.setZero(size, size);
  }
}

void NewtonMatrix::add(Index row, Index column, const MatrixXd& block) {
  if (!is_sparse_) {
    dense_.block(row, column, block.rows(), block.cols()) += block;
    return;
  }
  for (Index c = 0; c < block.cols(); ++c) {
    for (Index r = 0; r < block.rows(); ++r) add_entry(row + r, column + c, block(r, c));
  }
}

void NewtonMatrix::add_entry(Index row, Index column, double value) {
  entries_.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
}

VectorXd NewtonMatrix::solve_symmetric(const VectorXd& b) {
  if (!is_sparse_) {
    const Eigen::LLT<Eigen::Ref<MatrixXd>, Eigen::Lower> factor(dense_);
    return factor.solve(b);
  }
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor(sparse());
  if (factor.info() != Eigen::Success) return no_solution(size_);
  return factor.solve(b);
}

VectorXd NewtonMatrix::solve(const VectorXd& b) {
  if (!is_sparse_) {
    const Eigen::PartialPivLU<Eigen::Ref<MatrixXd>> factor(dense_);
    return factor.solve(b);
  }
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factor(sparse());
  if (factor.info() != Eigen::Success) return no_solution(size_);
  return factor.solve(b);
}

Eigen::SparseMatrix<double> NewtonMatrix::sparse() const {
  Eigen::SparseMatrix<double> matrix(size_, size_);
  matrix.setFromTriplets(entries_.begin(), entries_.end());
  return matrix;
}

}  // namespace prehend
