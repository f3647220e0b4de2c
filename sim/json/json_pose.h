// Poses in scene and grasp files: {"position": [x, y, z], "quaternion_wxyz": [w, x, y, z]}.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/base/pose.h"
#include "sim/json/json_field.h"

namespace prehend {

// Position in metres (default 0) and a rotation (default none). The quaternion is normalised; one
// that is not of length 1 within 1e-3 is an error.
Pose read_pose(const JsonField& field);

nlohmann::ordered_json pose_to_json(const Pose& pose);

nlohmann::ordered_json vector_to_json(const Vector3& v);

}  // namespace prehend
