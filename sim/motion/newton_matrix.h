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

  // Adds a block that begins there, or one number.
  void add(Eigen::Index row, Eigen::Index column, const Eigen::MatrixXd& block);

  void add(Eigen::Index row, Eigen::Index column, double value) {
    if (is_sparse_) {
      add_entry(row, column, value);
    } else {
      dense_(row, column) += value;
    }
  }

  // The solution x of (this) x = b. Of a symmetric matrix, which is positive definite, only what is
  // on and below the diagonal counts. Not finite where the matrix is singular. Ends the use of the
  // matrix until start().
  Eigen::VectorXd solve_symmetric(const Eigen::VectorXd& b);
  Eigen::VectorXd solve(const Eigen::VectorXd& b);

 private:
  void add_entry(Eigen::Index row, Eigen::Index column, double value);
  Eigen::SparseMatrix<double> sparse() const;

  bool is_sparse_ = false;
  Eigen::Index size_ = 0;
  Eigen::MatrixXd dense_;
  std::vector<Eigen::Triplet<double>> entries_;
};

}  // namespace prehend
