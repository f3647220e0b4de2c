// Where the hand of a scene stands before anybody has moved it.
#pragma once

#include <vector>

#include "planner/live/edited_scene.h"
#include "planner/live/hand_posture.h"
#include "sim/scene/reach/reach.h"

namespace prehend {

// Degrees of freedom of a hand at the start: those of its first preshape [rad or m].
std::vector<double> start_dofs(const Robot& hand);

// In these the hand points at the object and stands off it. It comes from above as the world has
// it, else from the sides: the first place where neither hand nor arm, if there is one, overlap
// anything; where the arm cannot be asked to, the first at which the hand is free. At the origin
// without an object; from above where no place is free or the scene cannot be used.
HandPosture start_posture(const EditedScene& world, const ReachOptions& options);

}  // namespace prehend
