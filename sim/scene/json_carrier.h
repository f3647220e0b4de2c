// The robot of a scene file: where its files are, and how it stands and starts.
#pragma once

#include <string>

#include "sim/robot/files/package_folders.h"
#include "sim/scene/scene.h"

namespace prehend {

class JsonField;  // sim/base/json/json_field.h

// A name of the library, or the absolute path of a file: beside the scene if there is one.
std::string read_robot_source(const JsonField& field);

// A platform of the field "robot" with its pose, start and limits, which may only be narrower than
// the robot's own. `hand` replaces the platform's own; empty: as it is. Throws InputError that
// names the field.
Carrier read_carrier(const JsonField& field, const std::string& hand,
                     const ForeignRobotOptions& foreign);

}  // namespace prehend
