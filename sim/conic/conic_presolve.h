// Scaling and reduction of a conic program before it is solved, and their reversal afterwards.
#pragma once

#include <Eigen/Core>

#include "sim/conic/conic_program.h"

namespace prehend {

// Rows, columns, right-hand side and objective are scaled to entries of the order of one, by powers
// of two (no rounding). All rows of a second-order cone share a factor. Source: Ruiz, "A scaling
// algorithm to equilibrate both rows and columns norms in matrices", 2001.
class Equilibration {
 public:
  explicit Equilibration(const ConicProgram& program);

  const ConicProgram& scaled() const { return scaled_; }

  // The solution of the unscaled program: x, y, z, s only.
  void restore(ConicSolution& solution) const;

 private:
  void scale_once();

  ConicProgram scaled_;
  Eigen::VectorXd columns_;
  Eigen::VectorXd rows_of_A_;
  Eigen::VectorXd rows_of_G_;
  double right_ = 1.0;      // b and h were divided by this
  double objective_ = 1.0;  // and c by this
};

// Leaves out rows of A that depend on others, and directions of x in the null spaces of both A
// and G.
//
// Either may prove the program infeasible: b outside the range of A, or c along such a direction.
// decided() is then true and solution() holds the certificate.
class Reduction {
 public:
  explicit Reduction(const ConicProgram& program);

  bool decided() const { return decided_; }
  const ConicSolution& solution() const { return solution_; }

  const ConicProgram& reduced() const { return reduced_; }

  // The solution of the program before the reduction: x and y only.
  void restore(ConicSolution& solution) const;

 private:
  void drop_rows(const ConicProgram& program);
  void drop_directions(const ConicProgram& program);
  void decide(const ConicProgram& program, ConicStatus status);

  bool decided_ = false;
  ConicSolution solution_;
  ConicProgram reduced_;
  Eigen::Index rows_ = 0;  // of A before
  Eigen::VectorXi kept_;   // the rows of A that remain
  Eigen::MatrixXd seen_;   // orthonormal basis of what [A; G] sees; no columns: all of it
};

}  // namespace prehend
