// Whether a set of grasps is one that files can hold.
#pragma once

#include "planner/results/datasets/grasp_set.h"

namespace prehend {

// Throws InputError that names the member ("grasps[3].contacts[0].link") unless every number is
// finite, poses are rigid, directions are unit (an approach may be zero), links exist, degrees of
// freedom and features are as many as their names or none, and texts are without a byte 0.
void require_sound(const GraspSet& set);

}  // namespace prehend
