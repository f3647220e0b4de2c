// The second-order cone program of the smallest contact forces that balance a unit wrench.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/quality/conic/conic_program.h"
#include "sim/quality/force_balance.h"

namespace prehend {

// The program of a ForceBalance. The variables are the coordinates v of all contacts' friction
// cones (friction_cone.h), one contact after the other, and, for the measure largest_normal, one
// more: the upper bound t of all normal forces.
class ForceProgram {
 public:
  // `balance` must live as long as the program.
  ForceProgram(const ForceBalance& balance, const ForceOptions& options);

  const ConicProgram& program() const { return program_; }

  // What each contact transmits, 4 x n as ContactForces::components: the solver's solution, put
  // inside the friction cones in spite of rounding, and then corrected towards the equations by the
  // smallest step in the metric of the cones' barrier. A correction that would leave the cones, or
  // raise the measure, is not made.
  Eigen::Matrix4Xd components(const ConicSolution& solution) const;

  // The multipliers of the solver's dual solution.
  ForceBalance::Separation separation(const ConicSolution& solution) const;

 private:
  void find_basis(const Eigen::MatrixXd& wrenches);
  void fill_equations();
  void fill_cones();
  Eigen::Index normal_rows() const;
  bool inside(const Eigen::VectorXd& v) const;
  Eigen::MatrixXd barrier_metric(const Eigen::VectorXd& v) const;
  Eigen::Matrix4Xd transmitted(const Eigen::VectorXd& v) const;
  Eigen::VectorXd polish(Eigen::VectorXd v) const;

  ForceOptions options_;
  const ForceBalance& balance_;
  std::vector<Eigen::Index> first_;  // index of each contact's first coordinate
  Eigen::Index coordinates_ = 0;
  std::vector<Eigen::Index> slack_;  // row of each contact's first slack in the cone
  Eigen::MatrixXd basis_;            // 6 x k: the orthonormal directions in which to balance
  ConicProgram program_;
};

}  // namespace prehend
