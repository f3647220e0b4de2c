// A platform whose hand holds the object.
#pragma once

#include "sim/scene/compiled_scene.h"

namespace prehend {

// The scene's arm with the object as one more link, the last one, fixed to the hand's base, which
// has the pose X_OH in the object's frame. Pairs that are checked for collision: those of the
// object with links that are not the hand's and with the obstacles, and those of the scene's arm
// but for the ones with the object where it stood. The object and the hand are no pair. The scene
// must have an arm.
CompiledArm arm_with_object(const CompiledScene& scene, const Pose& X_OH);

// The id of the object in such an arm.
LinkId carried_object(const CompiledArm& arm);

}  // namespace prehend
