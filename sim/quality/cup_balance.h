// The forces of grasps with sealed suction cups that balance a wrench.
#pragma once

#include <span>

#include <Eigen/Core>

#include "sim/quality/contact.h"
#include "sim/quality/contact_map.h"
#include "sim/quality/forces.h"

namespace prehend {

// Whether one of them is a suction cup.
bool has_cup(std::span<const Contact> contacts);

// What is the unit of a cup's forces.
enum class CupUnit {
  vacuum,   // the force of its vacuum, for wrench spaces, as the unit normal force of a finger
  newtons,  // the force of its vacuum, for wrenches in N; the unit normal force of a finger is 1 N
};

// The forces of the contacts, n contacts, that balance a wrench with the smallest measure.
struct CupForces {
  ForceOutcome outcome = ForceOutcome::limit;
  // Per contact, in the unit of the wrench: [force along the normal (of a cup, below 0: it pulls),
  // along the first and second tangent, torques about the normal, the first and second tangent].
  Eigen::Matrix<double, 6, Eigen::Dynamic> components;
  // What each contact spends: a cup, the part of its vacuum that would do; a finger, its normal
  // force over the unit.
  Eigen::VectorXd spent;
  double measure = 0.0;   // the largest of `spent`, or their sum; infinite if impossible
  double lowest = 0.0;    // proved lower bound of the measure
  double residual = 0.0;  // |sum of contact wrenches + external| / |external|
};

// The forces within the friction cones, and the sets of cups (suction_cup.h) shrunk to the part of
// their vacuum that they spend, whose wrenches and `external` add up to zero. `external` is
// [force; torque * torque_scale] in `frame`. A wrench is borne 1 / measure times. All cones are
// exact. A zero wrench needs no force; without contacts any other is impossible. Solved as a
// second-order cone program. Throws InputError as balancing_forces.
CupForces cup_forces(std::span<const Contact> contacts, const WrenchFrame& frame,
                     const Wrench& external, ForceMeasure measure, CupUnit unit);

}  // namespace prehend
