// Puts another object into a scene.
#pragma once

#include "sim/scene/scene.h"

namespace prehend {

// The object stands where that of the scene stood, turned as it was: the middle of its bounds on
// the same vertical line, its lowest point at the same height, in the world's frame. Primitives of
// the former object are left out.
void replace_object(Scene& scene, GraspableBody object);

}  // namespace prehend
