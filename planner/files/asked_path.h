// A motion of a robot as a grasp file has it.
#pragma once

#include "planner/path/trajectory.h"
#include "sim/json/json_field.h"
#include "sim/robot/robot.h"

namespace prehend {

// "joints", "times", "positions", "velocities" and "segments" (docs/grasps-file.md). Throws
// InputError that names the file and the field when it is no motion of this robot: other joints or
// another order of them, rows of another length, positions outside the limits, times that do not
// increase, segments that do not follow one another from the first sample to the last.
Trajectory asked_path(const JsonField& path, const Robot& robot);

}  // namespace prehend
