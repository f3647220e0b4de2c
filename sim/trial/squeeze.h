// Which way an object at rest begins to move between two fingers whose forces do not balance.
#pragma once

#include <optional>

#include "sim/trial/self_centering.h"
#include "sim/trial/trial.h"

namespace prehend {

// A small motion of the object: its point center_O moves by linear_O while it turns about that
// point by angular_O.
struct ObjectMotion {
  Vector3 center_O = Vector3::Zero();   // m
  Vector3 linear_O = Vector3::Zero();   // m
  Vector3 angular_O = Vector3::Zero();  // rad

  // By how much a point that moves with the object does.
  Vector3 at(const Vector3& p_O) const { return linear_O + angular_O.cross(p_O - center_O); }
};

// The pose of the hand relative to the object after `motion` of the object, the hand at rest. The
// turn is exact, not only its first order.
Pose after(const ObjectMotion& motion, const Pose& X_OH);

struct SqueezeLimits {
  double slide = 0.0;  // farthest that a point between the fingers moves [m]
  double angle = 0.0;  // largest turn [rad]
  // Forces count as balanced where their sum is smaller than this part of one finger's force, and
  // their torque than this arm times that force [m].
  double least_force = 0.0;
  double least_arm = 0.0;
};

// The fingers of a pair press with equal forces along the line on which they slide, each as nearly
// along it as friction allows: within the friction cone of a contact the force acts along that
// line, outside it along the edge of the cone that is nearest, and the contact slides. The sum F of
// the forces moves the point in the middle of the contacts, and their couple M turns the object
// about that point, where friction on both sides keeps it: v = F / m, w = M / I, with the object's
// mass and its mean moment of inertia about that point. Repeated in small steps, without keeping a
// velocity, this is the quasi-static motion of an object that resists only being set in motion.
//
// The motion has the largest size within the limits. None where a finger of the pair does not
// touch, or where the forces balance.
std::optional<ObjectMotion> squeezed(const CompiledScene& scene, const FingerPair& fingers,
                                     const Trial& trial, const SqueezeLimits& limits);

}  // namespace prehend
