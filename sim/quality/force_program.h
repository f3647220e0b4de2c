// The conic program of the contact forces that balance a unit wrench.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/quality/conic_program.h"
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

  // What each contact transmits (as ContactForces::components) for a solution x.
  Eigen::Matrix4Xd components(const Eigen::VectorXd& x) const;

  // The solution moved by the smallest step, in the metric of the cones' barrier, that meets the
  // equations; unchanged where such a step would leave the cones.
  Eigen::VectorXd polish(const Eigen::VectorXd& x) const;

  double measure(const Eigen::Matrix4Xd& components) const;
  double residual(const Eigen::Matrix4Xd& components) const;
  // By how much the worst joint torque exceeds its limit, relative to the limit; relative to the
  // torques that cancel where the limit is zero.
  double torque_excess(const Eigen::Matrix4Xd& components) const;

  // Multipliers of the balance and of the joint torques, of any length.
  struct Separation {
    Wrench wrench = Wrench::Zero();
    Eigen::VectorXd torques;
  };
  Separation separation(const ConicSolution& solution) const;

  // No forces that balance the wrench have a smaller measure; any separation is a proof. Where it
  // is above zero at all, rounding of the separation is accounted for.
  double lower_bound(const Separation& separation, ForceMeasure measure) const;

 private:
  void add_contacts(std::span<const Contact> contacts, const WrenchFrame& frame);
  void add_joints(std::span<const Contact> contacts, const HandTorques& hand, double size);
  void fill_equations();
  void fill_cones();
  Eigen::MatrixXd barrier_metric(const Eigen::VectorXd& x) const;

  ForceOptions options_;
  Wrench wrench_;
  std::vector<ContactCone> cones_;
  std::vector<Eigen::Index> first_;  // coordinate of each contact, the orthant's in any order
  Eigen::Index coordinates_ = 0;
  Eigen::MatrixXd maps_;              // 6 x 4n: wrenches of components
  Eigen::MatrixXd loads_;             // joints x 4n: joint torques of components
  Eigen::VectorXd limits_;            // joints, for the unit wrench
  std::vector<Eigen::Index> locked_;  // joints that bear nothing
  std::vector<Eigen::Index> limited_;
  ConicProgram program_;
};

}  // namespace prehend
