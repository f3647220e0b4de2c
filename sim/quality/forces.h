// The contact forces that balance a wrench, and how large a wrench contacts can resist.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include <Eigen/Core>

#include "sim/base/named_enum.h"
#include "sim/base/settings.h"
#include "sim/quality/contact.h"
#include "sim/quality/contact_map.h"
#include "sim/quality/friction_cone.h"

namespace prehend {

// The norm of the contact forces that is minimised, or limited to one.
enum class ForceMeasure {
  largest_normal,  // L-infinity: each contact pushes with its own actuator
  sum_of_normals,  // L1: all contacts share one
};
constexpr auto enum_names(ForceMeasure /*of*/) {
  return std::to_array<std::string_view>({"largest_normal", "sum_of_normals"});
}

struct ForceOptions {
  static constexpr AboutSettings kAbout{"ForceOptions", "Which contact forces balance a wrench."};
  ForceMeasure measure = ForceMeasure::largest_normal;
  FrictionCone cone = FrictionCone::exact;
  int edges = 8;
  double residual_tolerance = 1e-8;
  double gap_tolerance = 1e-6;
};

template <SettingsOf<ForceOptions> Options, typename Visit>
void for_each_setting(Options& options, const Visit& visit) {
  auto& [measure, cone, edges, residual_tolerance, gap_tolerance] = options;
  visit("measure", measure,
        "What is made as small as it can be: each contact has its own actuator, or all share one.");
  visit("cone", cone, "The friction cone: exact, or a pyramid.");
  visit("edges", edges, kConeEdges, "", "Of a pyramid.");
  visit("residual_tolerance", residual_tolerance, kRatioAbove0, "",
        "Forces count as balanced when they leave at most this part of the wrench over, and exceed "
        "no joint torque's limit by more than this part of it.");
  visit("gap_tolerance", gap_tolerance, kRatioAbove0, "",
        "And when their measure is within this part of the proved lower bound.");
}

// The joint torques that the contact forces cause in the hand, and their limits: |J' f| <= limits,
// with f the stacked forces of the contacts on the object. The torques of soft fingers about their
// normals load the joints through `spin`; where it is empty they load none.
struct HandTorques {
  Eigen::MatrixXd jacobian;  // 3n x joints: velocities of the contact points in the axes of the
                             // contacts [m/s per rad/s]
  Eigen::VectorXd limits;    // joints: >= 0 [Nm for forces in N]; infinite: no limit
  Eigen::MatrixXd spin;      // n x joints: angular velocities about the normals [rad/s per rad/s];
                             // or empty
};

// What is known about the balancing forces.
enum class ForceOutcome {
  balanced,    // within both tolerances
  impossible,  // proved: see ContactForces::separating
  limit,       // rounding allows neither; the best forces found stand
};

// The enumerator's name, as it is written in files.
constexpr auto enum_names(ForceOutcome /*of*/) {
  return std::to_array<std::string_view>({"balanced", "impossible", "limit"});
}

// The contact forces found, n contacts. Forces are in the unit of the external wrench's force,
// torques in that unit times a metre.
struct ContactForces {
  ForceOutcome outcome = ForceOutcome::limit;
  Eigen::Matrix4Xd components;  // per contact: [normal force, along the first and second tangent,
                                // torque about the normal]; tangents are contact_tangents()
  Eigen::Matrix3Xd forces;      // per contact: the force on the object, in the axes of the contacts
  double largest_normal = 0.0;
  double sum_of_normals = 0.0;
  double residual = 0.0;  // |sum of contact wrenches + external| / |external|
  double lowest = 0.0;    // lower bound of the measure, proved by the dual solution
  double gap = 0.0;       // (measure - lowest) / measure
  // Only if impossible: the proof. A unit wrench u with u . w >= 0 for the wrench w of any forces
  // in the friction cones, and u . external > 0: their sum cannot vanish. With joint limits L there
  // is also a multiplier l_j for each joint: u . w + l . J'f >= 0 for all forces f in the cones,
  // and u . external > sum of |l_j| L_j. This holds up to rounding: what is proved strictly is that
  // the normal forces would add up to more than 1e10 times the wrench (kLargestForce).
  Wrench separating = Wrench::Zero();
  Eigen::VectorXd torque_multipliers;  // joints, with a hand; for the unit wrench above
};

// Where balance would take normal forces that add up to more than this times the wrench, it counts
// as impossible: solutions so large are rounding errors of a grasp that cannot balance the wrench.
inline constexpr double kLargestForce = 1e10;

// The forces inside the friction cones whose wrenches and `external` add up to zero, with the
// smallest measure; with a `hand`, within its joint torque limits too. `external` is
// [force; torque * torque_scale] in `frame`. A zero wrench needs no force; without contacts any
// other is impossible. Solved as a second-order cone program. Source: Boyd and Wegbreit, "Fast
// computation of optimal contact forces", 2007; Lobo et al., "Applications of second-order cone
// programming", 1998, section 3.7; joint torques as in Buss, Hashimoto and Moore 1996.
//
// Suction cups have cup_forces (cup_balance.h): only wrench_resistance takes them as well, with
// their vacuum as the unit and exact cones.
//
// Throws InputError as check_contacts does, for suction cups, for a wrench, options, joint limits
// or entries of the matrices that are out of range (ranges.h), and for matrices of the wrong shape.
ContactForces balancing_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                               const Wrench& external, const ForceOptions& options = {});
ContactForces balancing_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                               const Wrench& external, const HandTorques& hand,
                               const ForceOptions& options = {});

// How many times `external` the forces within the friction cones and joint limits of `hand`
// balance, at most `most` times. From below, for forces were found that do it, and within 1e-5 of
// itself unless rounding stands in the way. 0: no forces balance it. Throws as balancing_forces.
double times_borne(std::span<const Contact> contacts, const WrenchFrame& frame,
                   const Wrench& external, const HandTorques& hand, double most);

// Bounds lower <= k <= upper of the multiple k of a wrench that contacts can resist. Where it
// cannot be balanced, both are 0; for a zero wrench both are infinite.
struct Resistance {
  double lower = 0.0;
  double upper = 0.0;
  ForceOutcome outcome = ForceOutcome::limit;
};

// The largest k for which forces of measure at most 1 balance k times `external`. Since forces
// scale with the wrench, that is one over the smallest measure that balances `external` itself.
// Throws as balancing_forces.
Resistance wrench_resistance(std::span<const Contact> contacts, const WrenchFrame& frame,
                             const Wrench& external, const ForceOptions& options = {});

}  // namespace prehend
