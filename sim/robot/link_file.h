// Reads a link of a robot file (docs/robot-file.md, "Links" and "Mass").
#pragma once

#include "sim/json/json_field.h"
#include "sim/robot/robot.h"
#include "sim/robot/robot_geometry.h"

namespace prehend {

// Name, material, geometry and mass of a link that follows `joint` (-1: the base). Which fields
// there may be is the caller's to check. Throws InputError that names the field: an unknown
// material, a geometry without a solid whose mass is to be found from it, an inertia that no body
// has.
Link read_link(const JsonField& field, const FileUnits& units, const NamedGeometry& named,
               int joint);

}  // namespace prehend
