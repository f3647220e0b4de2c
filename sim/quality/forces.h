// The contact forces that balance a wrench, and how large a wrench contacts can resist.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include <Eigen/Core>

#include "sim/quality/contact.h"
#include "sim/quality/contact_map.h"
#include "sim/quality/friction_cone.h"

namespace prehend {

// The norm of the contact forces that is minimised, or limited to one.
enum class ForceMeasure {
  largest_normal,  // L-infinity: each contact pushes with its own actuator
  sum_of_normals,  // L1: all contacts share one
};

struct ForceOptions {
  ForceMeasure measure = ForceMeasure::largest_normal;
  FrictionCone cone = FrictionCone::exact;
  int edges = 8;  // >= 3, of the pyramid
  // What is called balanced: of the wrench left over, relative to the wrench, and of joint torques
  // beyond their limits, relative to the limits.
  double residual_tolerance = 1e-8;
  double gap_tolerance = 1e-6;  // of the measure, relative
};

// The hand's joint torques that the contact forces cause, and their limits: |J'f| <= limits, f the
// forces of the contacts on the object one after the other. `spin` is for the torques of soft
// fingers, which load no joint without it.
struct HandTorques {
  Eigen::MatrixXd jacobian;  // 3n x joints: velocities of the contact points in the axes of the
                             // contacts [m/s per rad/s]
  Eigen::VectorXd limits;    // joints: >= 0 [Nm for forces in N]; infinite: no limit
  Eigen::MatrixXd spin;      // n x joints: angular velocities about the normals [rad/s per rad/s];
                             // or empty
};

enum class ForceOutcome {
  balanced,    // within both tolerances
  impossible,  // proved: see ContactForces::separating
  limit,       // rounding allows neither; the best forces found stand
};

constexpr std::string_view force_outcome_name(ForceOutcome outcome) {
  constexpr std::array<std::string_view, 3> kNames = {"balanced", "impossible", "limit"};
  return kNames[static_cast<std::size_t>(outcome)];
}

// Forces are in the unit of the wrench's force, torques in that unit times a metre.
struct ContactForces {
  ForceOutcome outcome = ForceOutcome::limit;
  Eigen::Matrix4Xd components;  // per contact: [normal force, along the first and second tangent,
                                // torque about the normal]; tangents are contact_tangents()
  Eigen::Matrix3Xd forces;      // per contact: the force on the object, in the axes of the contacts
  double largest_normal = 0.0;
  double sum_of_normals = 0.0;
  double residual = 0.0;  // |sum of contact wrenches + external| / |external|
  double lowest = 0.0;    // no forces have a smaller measure than this: proved by the dual
  double gap = 0.0;       // (measure - lowest) / measure
  // Impossible: a unit wrench u that every contact's forces have a power u . w >= 0 with, and the
  // external wrench too, above 0, so that their sum cannot vanish. With joint limits L there is a
  // torque multiplier l for each joint: u . (wrench of f) + l . J'f >= 0 for all f of the cones,
  // and u . external > sum of |l_j| L_j. Up to rounding: what is proved is that the normal forces
  // would add up to more than 1e10 times the wrench (kLargestForce).
  Wrench separating = Wrench::Zero();
  Eigen::VectorXd torque_multipliers;  // joints, with a hand; for the unit wrench above
};

// Normal forces that add up to more than this times the wrench are taken for rounding errors of a
// grasp that cannot balance it.
inline constexpr double kLargestForce = 1e10;

// The forces inside the friction cones whose wrenches and `external` add up to zero, smallest in
// the measure. A zero wrench needs no force; without contacts any other is impossible. One
// second-order cone program. Source: Boyd and Wegbreit, "Fast computation of optimal contact
// forces", 2007; Lobo et al., "Applications of second-order cone programming", 1998, section 3.7;
// joint torques as in Buss, Hashimoto and Moore 1996.
//
// Throws InputError as check_contacts, for a wrench that is not finite, for options out
// of range, and for matrices of the wrong shape or that are not finite, or negative limits.
ContactForces balancing_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                               const Wrench& external, const ForceOptions& options = {});
ContactForces balancing_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                               const Wrench& external, const HandTorques& hand,
                               const ForceOptions& options = {});

// lower <= k <= upper. Impossible: both 0. Zero wrench: both infinite.
struct Resistance {
  double lower = 0.0;
  double upper = 0.0;
  ForceOutcome outcome = ForceOutcome::limit;
};

// The largest k for which forces of measure at most 1 balance k times `external`: one over the
// smallest measure that balances it. Throws as balancing_forces.
Resistance wrench_resistance(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const Wrench& external, const ForceOptions& options = {});

}  // namespace prehend
