// The hand's straight motion to a grasp, as an arm has to follow it.
#pragma once

#include "sim/scene/reach/reach.h"

namespace prehend {

struct Candidate;
struct CompiledScene;
struct Trial;

// The straight motion of the hand from the pre-grasp to the grasp of `trial`, with the joint values
// at which the candidate starts.
HandLine approach_line(const CompiledScene& scene, const Candidate& candidate, const Trial& trial);

}  // namespace prehend
