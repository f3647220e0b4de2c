// The conic program of the contact forces that balance a unit wrench.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/conic/conic_program.h"
#include "sim/quality/forces.h"

namespace prehend {

// Forces are in units of the external wrench. The program's variables are the coordinates of all
// contacts' cones and, for the measure largest_normal, that largest normal.
class ForceProgram {
 public:
  // `wrench` is unit, `size` what it was before. `hand` may be null; what is given is checked.
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
  std::vector<Eigen::Index> first_;  // of each contact, its first coordinate
  Eigen::Index coordinates_ = 0;
  std::vector<Eigen::Index> slack_;   // row of each contact's first slack in the cone
  Eigen::MatrixXd basis_;             // 6 x k: the orthonormal directions in which to balance
  Eigen::MatrixXd maps_;              // 6 x 4n: wrenches of components
  Eigen::MatrixXd loads_;             // joints x 4n: joint torques of components
  Eigen::VectorXd limits_;            // joints, for the unit wrench
  std::vector<Eigen::Index> locked_;  // joints that bear nothing
  std::vector<Eigen::Index> limited_;
  ConicProgram program_;
};

}  // namespace prehend
