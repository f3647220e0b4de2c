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

  // What each contact transmits (as ContactForces::components): the solution, inside the cones
  // whatever the rounding, moved by the smallest step in the metric of their barrier that meets the
  // equations; not moved where that would leave the cones.
  Eigen::Matrix4Xd components(const ConicSolution& solution) const;

  double measure(const Eigen::Matrix4Xd& components) const;
  double residual(const Eigen::Matrix4Xd& components) const;
  // By how much the worst joint torque exceeds its limit, relative to the limit; where that
  // is zero, relative to the torque of the largest force.
  double torque_excess(const Eigen::Matrix4Xd& components) const;

  // Multipliers of the balance and of the joint torques, of any length.
  struct Separation {
    Wrench wrench = Wrench::Zero();
    Eigen::VectorXd torques;
  };
  Separation separation(const ConicSolution& solution) const;

  // No forces within the limits that leave no more than `residual` of the wrench have a smaller
  // measure; any separation proves a bound. Its rounding is accounted for. Infinite where even that
  // is zero.
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
