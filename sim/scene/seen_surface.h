// What of an object's surface a camera saw.
#pragma once

#include <optional>

#include "sim/scene/compiled_scene.h"

namespace prehend {

// Whether a camera saw the triangle of the object that is nearest to this point; the first of
// equals. Nothing for an object whose surface is known.
std::optional<bool> is_seen_at(const CompiledScene& scene, const Vector3& p_O);

}  // namespace prehend
