// Poses in scene and grasp files: {"position": [x, y, z], "quaternion_wxyz": [w, x, y, z]}.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/base/json/json_field.h"
#include "sim/base/pose.h"
#include "sim/base/range.h"

namespace prehend {

// Reads "position" [m] (default: the origin) and "quaternion_wxyz" (default: no rotation). The
// quaternion is normalised. Throws InputError when its length differs from 1 by more than 1e-3, for
// a position beyond kFarthest, and for unknown fields.
Pose read_pose(const JsonField& field);

// The pose in the same form, with w >= 0.
nlohmann::ordered_json pose_to_json(const Pose& pose);

// The list [x, y, z].
nlohmann::ordered_json vector_to_json(const Vector3& v);

}  // namespace prehend
