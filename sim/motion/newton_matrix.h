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

  // Adds a block that begins there.
  void add(Eigen::Index row, Eigen::Index column, const Eigen::MatrixXd& block);

  // Adds `columns` times `factors`, below each other from `row` on: those of their rows from
  // `begin` up to `end`.
  void add_to_column(Eigen::Index row, Eigen::Index begin, Eigen::Index end, Eigen::Index column,
                     const Eigen::MatrixX4d& columns, const Eigen::Vector4d& factors);

  // The solution x of (this) x = b. Of a symmetric matrix, which is positive definite, only what is
  // on and below the diagonal counts. Not finite where the matrix is singular.
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
