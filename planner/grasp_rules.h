// The grasp rules of each primitive, without a hand: where to aim, from where, closing along what.
#pragma once

#include <string>
#include <vector>

#include "planner/candidates.h"

namespace prehend {

struct AimedGrasp {
  Vector3 target_O = Vector3::Zero();     // where the hand's origin is aimed, object frame [m]
  Vector3 approach_O = Vector3::UnitZ();  // unit
  Vector3 closing_O = Vector3::UnitX();   // unit, orthogonal to approach
  double width = 0.0;                     // of the primitive along closing [m]
  std::string rule;
};

std::vector<AimedGrasp> aim_at(const Primitive& primitive, const CandidateOptions& options);

}  // namespace prehend
