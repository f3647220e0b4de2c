// Primitives in scene and grasp files.
#pragma once

#include "sim/base/json/json_pose.h"
#include "sim/shape/mass_parts.h"
#include "sim/shape/primitive.h"

namespace prehend {

// "shape", its sizes and "pose", metres (docs/reference/scene-file.md). Throws InputError that
// names the field.
Primitive read_primitive(const JsonField& field);

// The fields that read_primitive reads.
nlohmann::ordered_json primitive_to_json(const Primitive& primitive);

// "point" and "normal" of a plane, and what lies on the side to which the normal points.
BeyondPlane read_beyond(const JsonField& field);
nlohmann::ordered_json beyond_to_json(const BeyondPlane& plane);

}  // namespace prehend
