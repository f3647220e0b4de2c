// A motion of a robot in a grasp file: "joints", "times", "positions", "velocities" and "segments"
// (docs/reference/grasps-file.md).
#pragma once

#include "sim/base/json/json_fields.h"
#include "sim/motion/control/trajectory.h"
#include "sim/robot/robot.h"

namespace prehend {

// All fields are needed, since a motion makes no sense without one of them. What they must satisfy
// together (rows as long as lists, increasing times, segments without gaps) is checked after all of
// them were read.
void trajectory_fields(auto& fields, auto& trajectory) {
  for (const char* name : {"joints", "times", "positions", "velocities", "segments"}) {
    fields.needs(name);
  }
  fields("joints", trajectory.joints);
  fields("times", trajectory.times);
  fields("positions", trajectory.positions);
  fields("velocities", trajectory.velocities);
  fields.objects("segments", trajectory.segments, [](auto& inner, auto& segment) {
    for (const char* name : {"name", "first", "last"}) inner.needs(name);
    inner("name", segment.name);
    inner("first", segment.first);
    inner("last", segment.last);
  });
}

// Throws InputError that names the file and the field when it is no motion of this robot: other
// joints or another order of them, rows of another length, positions outside the limits, times that
// do not increase, segments that do not follow one another from the first sample to the last.
Trajectory read_trajectory(const JsonField& field, const Robot& robot);

}  // namespace prehend
