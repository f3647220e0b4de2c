// Poses in GraspIt! files.
#pragma once

#include <numbers>

#include "sim/base/xml/xml_file.h"

namespace prehend {

// Metres per unit of length in GraspIt! files.
inline constexpr double kGraspitLength = 1e-3;
// Radians per unit of angle.
inline constexpr double kGraspitAngle = std::numbers::pi / 180.0;

// The pose that an element <transform> states: its steps <translation> (x y z [mm]), <rotation>
// (angle [deg] and x, y or z), <rotationMatrix> (nine numbers, column by column) and
// <fullTransform>
// ("(w x y z)[x y z]", mm), multiplied from left to right. Throws InputError with the line for
// other steps, and for rotations that are none.
Pose read_graspit_transform(const XmlElement& transform);

// The content as three numbers, times `unit`.
Vector3 graspit_vector(const XmlElement& element, double unit);

}  // namespace prehend
