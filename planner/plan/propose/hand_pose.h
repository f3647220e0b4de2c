// From an aimed grasp to a pose of the hand, and from where it approaches.
#pragma once

#include <vector>

#include "planner/plan/propose/grasp_rules.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

// Pose X_OH of the hand whose approach and closing directions are those of the aimed grasp, and
// whose grasp origin is `stand_off` [m] short of the target.
Pose hand_pose(const Hand& hand, const AimedGrasp& aimed, double stand_off);

// How far the hand with these degrees of freedom reaches beyond its origin along its approach [m].
double hand_reach(const CompiledScene& scene, const std::vector<double>& dofs);

// How far before X_OH the approach along the unit direction `approach_O` starts [m]: so that,
// measured along the approach, the foremost point of the hand is `clearance` before the nearest
// point of the object. Then the two cannot overlap, whatever their shapes. `reach`: hand_reach.
double approach_distance(const CompiledScene& scene, const Pose& X_OH, const Vector3& approach_O,
                         double reach, double clearance);

}  // namespace prehend
