// Robots as the page moves them: a tree of frames, and numbers short enough for a report.
#pragma once

#include <nlohmann/json.hpp>

#include "sim/scene/compiled_arm.h"

namespace prehend {

// Numbers rounded to a multiple of 1 / scale, to keep the report small.
double rounded(double value, double scale = 1e6);
nlohmann::ordered_json rounded(const Vector3& v, double scale = 1e6);

// Position [m], then a unit quaternion x, y, z, w.
nlohmann::ordered_json rounded(const Pose& pose);

// The number rounded to six significant digits.
double significant(double value);

// "joints": for each its parent's number (-1: the base), whether it turns about its axis ("r") or
// slides along it ("p"), the axis (unit, null: z) in the frame before the motion, and the fixed
// poses before and after that motion (null: none). "links": name, joint (-1: the base), material,
// mesh (simplified where it is large).
nlohmann::ordered_json robot_json(const Robot& robot);

// The platform in the same way, without the hand's links, with its base ("X", in the world), the
// frame that carries the hand ("hand_joint", "X_hand"), the hand's first joint ("first_hand_joint")
// and where it starts ("start").
nlohmann::ordered_json arm_json(const CompiledArm& arm);

}  // namespace prehend
