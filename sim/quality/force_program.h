// The second-order cone program of the smallest contact forces that balance a unit wrench
// (see forces.h), and the checks of its solution that do not rely on the solver.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/conic/conic_program.h"
#include "sim/quality/forces.h"

namespace prehend {

// The program for n contacts. Forces are in units of the external wrench. The variables are the
// coordinates v of all contacts' friction cones (friction_cone.h), one contact after the other,
// and, for the measure largest_normal, one more: the upper bound t of all normal forces.
class ForceProgram {
 public:
  // `wrench` is the external wrench divided by its norm `size`. `hand` may be null: no joint
  // limits. The arguments must have been checked already (forces.cpp does so).
  ForceProgram(std::span<const Contact> contacts, const WrenchFrame& frame, const Wrench& wrench,
               double size, const HandTorques* hand, const ForceOptions& options);

  const ConicProgram& program() const { return program_; }

  // What each contact transmits, 4 x n as ContactForces::components: the solver's solution, put
  // inside the friction cones in spite of rounding, and then corrected towards the equations by the
  // smallest step in the metric of the cones' barrier. A correction that would leave the cones, or
  // raise the measure, is not made.
  Eigen::Matrix4Xd components(const ConicSolution& solution) const;

  // The measure that is minimised (ForceOptions::measure): sum or largest of the normal forces.
  double measure(const Eigen::Matrix4Xd& components) const;
  // Norm of the sum of the contact wrenches and the unit external wrench: 0 is perfect balance.
  double residual(const Eigen::Matrix4Xd& components) const;
  // By how much the worst joint torque exceeds its limit, relative to the limit; where the limit
  // is zero, relative to the torque of the largest force.
  double torque_excess(const Eigen::Matrix4Xd& components) const;

  // Lagrange multipliers of the balance of wrenches and of the joint torques, in any common scale:
  // a hyperplane that separates what the contacts can do from what they should do.
  struct Separation {
    Wrench wrench = Wrench::Zero();
    Eigen::VectorXd torques;  // one for each joint; 0 for a joint without a limit
  };
  // The multipliers of the solver's dual solution.
  Separation separation(const ConicSolution& solution) const;

  // A lower bound, by weak duality, of the measure of all forces that keep the joint limits and
  // balance the unit wrench up to a remainder of norm `residual`. Valid for any separation, exact
  // or not, since rounding of the bound itself is accounted for; 0 where it proves nothing, and
  // infinite where it proves that no forces balance the wrench.
  double lower_bound(const Separation& separation, ForceMeasure measure,
                     double residual = 0.0) const;

 private:
  void add_contacts(std::span<const Contact> contacts, const WrenchFrame& frame);
  void add_joints(std::span<const Contact> contacts, const HandTorques& hand, double size);
  void find_basis(const Eigen::MatrixXd& wrenches);
  void fill_equations();
  void fill_cones();
  Eigen::Index normal_rows() const;
  bool inside(const Eigen::VectorXd& v) const;
  Eigen::MatrixXd barrier_metric(const Eigen::VectorXd& v) const;
  Eigen::Matrix4Xd transmitted(const Eigen::VectorXd& v) const;
  Eigen::VectorXd polish(Eigen::VectorXd v) const;

  ForceOptions options_;
  Wrench wrench_;
  std::vector<ContactCone> cones_;
  std::vector<Eigen::Index> first_;  // index of each contact's first coordinate
  Eigen::Index coordinates_ = 0;
  std::vector<Eigen::Index> slack_;    // row of each contact's first slack in the cone
  Eigen::MatrixXd basis_;              // 6 x k: the orthonormal directions in which to balance
  Eigen::MatrixXd maps_;               // 6 x 4n: maps components to wrenches
  Eigen::MatrixXd loads_;              // joints x 4n: maps components to joint torques
  Eigen::VectorXd limits_;             // joints: torque limits, divided by the wrench's norm
  std::vector<Eigen::Index> locked_;   // joints with limit 0, which bear no torque
  std::vector<Eigen::Index> limited_;  // joints with a positive, finite limit
  ConicProgram program_;
};

}  // namespace prehend
