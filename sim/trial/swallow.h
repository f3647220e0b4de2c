// Bodies that overlap although their surfaces do not meet: one is wholly inside the other.
#pragma once

#include "sim/scene/compiled_scene.h"

namespace prehend {

// True when a component of the link is inside the object (obstacle -1) or the obstacle, or one of
// theirs inside the link. `X_BL`: the link's pose in that body's frame. Bodies that are not solid
// have no inside.
bool is_swallowed(const CompiledScene& scene, const CompiledLink& link, int obstacle,
                  const Pose& X_BL);

}  // namespace prehend
