// The matrix of a Newton step on the velocities of an island: dense where bodies are few, sparse
// where most pairs of them do not meet.
#pragma once

#include <vector>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace prehend {

class NewtonMatrix {
 public:
  // Zero, for so many velocities.
  void start(Eigen::Index size);

  template <typename Derived>
  void add(Eigen::Index row, Eigen::Index column, const Eigen::MatrixBase<Derived>& block) {
    if (!is_sparse_) {
      dense_.block(row, column, block.rows(), block.cols()) += block;
      return;
    }
    for (Eigen::Index c = 0; c < block.cols(); ++c) {
      for (Eigen::Index r = 0; r < block.rows(); ++r) {
        entries_.emplace_back(static_cast<int>(row + r), static_cast<int>(column + c), block(r, c));
      }
    }
  }

  // The solution x of (this) x = b. Of a symmetric matrix, which is positive definite, only what is
  // on and below the diagonal counts. Not finite where the matrix is singular.
  Eigen::VectorXd solve_symmetric(const Eigen::VectorXd& b);
  Eigen::VectorXd solve(const Eigen::VectorXd& b);

 private:
  Eigen::SparseMatrix<double> sparse() const;

  bool is_sparse_ = false;
  Eigen::Index size_ = 0;
  Eigen::MatrixXd dense_;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace prehend
