// What contact forces must balance, and checks of forces and of bounds that rely on no solver.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "sim/quality/forces.h"

namespace prehend {

// The contacts, the unit wrench that their forces must balance, and the joint limits. Forces are in
// units of the external wrench; components are 4 x n as in ContactForces.
class ForceBalance {
 public:
  // `wrench` is the external wrench divided by its norm `size`. `hand` may be null: no joint
  // limits. The arguments must have been checked already (forces.cpp does so).
  ForceBalance(std::span<const Contact> contacts, const WrenchFrame& frame, const Wrench& wrench,
               double size, const HandTorques* hand, const ForceOptions& options);

  const Wrench& wrench() const { return wrench_; }
  const std::vector<ContactCone>& cones() const { return cones_; }
  Eigen::Index contacts() const { return std::ssize(cones_); }
  // 6 x 4: maps the components of contact i to its wrench.
  auto map(Eigen::Index i) const { return maps_.middleCols<4>(4 * i); }
  // Joints x 4: maps the components of contact i to joint torques.
  auto loads(Eigen::Index i) const { return loads_.middleCols<4>(4 * i); }
  // Joints: torque limits, divided by the wrench's norm.
  const Eigen::VectorXd& limits() const { return limits_; }
  // Joints with limit 0, which bear no torque, and those with a positive, finite limit.
  const std::vector<Eigen::Index>& locked() const { return locked_; }
  const std::vector<Eigen::Index>& limited() const { return limited_; }

  // ForceOptions::measure of forces: sum or largest of the normal forces.
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
  // A lower bound, by weak duality, of the measure of all forces that keep the joint limits and
  // balance the unit wrench up to a remainder of norm `residual`. Valid for any separation, exact
  // or not, since rounding of the bound itself is accounted for; 0 where it proves nothing, and
  // infinite where it proves that no forces balance the wrench.
  double lower_bound(const Separation& separation, ForceMeasure measure,
                     double residual = 0.0) const;

 private:
  void add_contacts(std::span<const Contact> contacts, const WrenchFrame& frame,
                    const ForceOptions& options);
  void add_joints(std::span<const Contact> contacts, const HandTorques& hand, double size);

  ForceMeasure measure_;
  Wrench wrench_;
  std::vector<ContactCone> cones_;
  Eigen::MatrixXd maps_;   // 6 x 4n
  Eigen::MatrixXd loads_;  // joints x 4n
  Eigen::VectorXd limits_;
  std::vector<Eigen::Index> locked_;
  std::vector<Eigen::Index> limited_;
};

// What a search for the smallest forces found: forces in the friction cones, and the multipliers
// that bound the measure of all others from below. Both are judged by ForceBalance.
struct ProposedForces {
  Eigen::Matrix4Xd components;
  ForceBalance::Separation separation;
};

}  // namespace prehend
