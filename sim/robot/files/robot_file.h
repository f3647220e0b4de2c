// Reads robot files (docs/reference/robot-file.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/robot/files/package_folders.h"
#include "sim/robot/robot.h"

namespace prehend {

class JsonFile;  // sim/base/json/json_field.h

// The robot that a file describes, in SI units; also one in another program's format
// (foreign_robot.h), of which a hand on an arm is read as the hand alone. Throws InputError that
// names the file, the field and the value: an unknown or missing field, a joint without a degree of
// freedom or a degree of freedom without a joint, a lower limit above the upper one, a preshape
// outside limits, a link without triangles, a mesh that cannot be read.
Robot load_robot(const std::filesystem::path& file, const ForeignRobotOptions& options = {});
// As load_robot, of a file that was parsed already.
Robot read_robot(const JsonFile& file);

// A robot of the library by name ("barrett"), or a robot file by path.
// Throws InputError that lists the names when it is neither.
Robot find_robot(const std::string& name_or_file, const ForeignRobotOptions& options = {});

// Names of the robots that come with prehend, for find_robot.
std::vector<std::string> library_robot_names();
// Whether a robot or a platform that comes with prehend has this name.
bool is_library_robot(const std::string& name);

}  // namespace prehend
