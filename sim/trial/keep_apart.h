// How far a hand stays from obstacles that it must keep away from.
#pragma once

#include <optional>
#include <vector>

#include "sim/trial/approach.h"
#include "sim/trial/hand_collision.h"

namespace prehend {

// Where a hand has been in a trial.
struct HandWay {
  const ApproachMotion& motion;              // of the open hand
  double travel = 0.0;                       // that it moved [m]
  const std::vector<double>& open_joints;    // [rad or m]
  Pose X_OH = Pose::Identity();              // of the closed hand
  const std::vector<double>& closed_joints;  // [rad or m]
};

// The first link that comes nearer to an obstacle than its StaticBody::apart, with the hand closed
// or on its way to the object; distances on the way are proven down to 95 % of that. While it
// closes, the hand is not looked at: fingers that stop at an obstacle are near it at the end as
// well.
std::optional<HandContact> too_near(const CompiledScene& scene, const HandWay& way,
                                    HandCollisionWorkspace& workspace);

}  // namespace prehend
