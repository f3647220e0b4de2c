// A motion of a robot in a grasp file: "joints", "times", "positions", "velocities" and "segments"
// (docs/grasps-file.md).
#pragma once

#include "sim/base/json/json_field.h"
#include "sim/motion/control/trajectory.h"
#include "sim/robot/robot.h"

namespace prehend {

nlohmann::ordered_json trajectory_to_json(const Trajectory& trajectory);

// Throws InputError that names the file and the field when it is no motion of this robot: other
// joints or another order of them, rows of another length, positions outside the limits, times that
// do not increase, segments that do not follow one another from the first sample to the last.
Trajectory read_trajectory(const JsonField& field, const Robot& robot);

}  // namespace prehend
