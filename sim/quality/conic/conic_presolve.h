// Scaling and reduction of a conic program before it is solved, and their reversal afterwards.
#pragma once

#include <Eigen/Core>

#include "sim/quality/conic/conic_program.h"

namespace prehend {

// Equilibration: rows, columns, right-hand side and objective are scaled until their largest
// entries are of the order of one. The factors are powers of two, so that nothing is rounded. All
// rows of one second-order cone share a factor, since only a common one maps the cone to itself.
// Source: Ruiz, "A scaling algorithm to equilibrate both rows and columns norms in matrices", 2001.
class Equilibration {
 public:
  explicit Equilibration(const ConicProgram& program);

  const ConicProgram& scaled() const { return scaled_; }

  // Turns the solution of the scaled program into that of the given one: x, y, z and s only.
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

// Makes the rows of A and the columns of [A; G] linearly independent, as interior_point needs them:
// leaves out rows of A that depend on others, and directions of x that neither A nor G sees (their
// common null space).
//
// Either step may already decide the program: it is primal infeasible where b is outside the range
// of A, and dual infeasible where c has a component along a direction that is not seen. decided()
// is then true and solution() holds the certificate.
class Reduction {
 public:
  explicit Reduction(const ConicProgram& program);

  bool decided() const { return decided_; }
  const ConicSolution& solution() const { return solution_; }

  const ConicProgram& reduced() const { return reduced_; }

  // Turns the solution of the reduced program into that of the given one: changes x and y only.
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
  Eigen::MatrixXd seen_;   // orthonormal basis of the row space of [A; G]; empty: all of R^n
};

}  // namespace prehend
