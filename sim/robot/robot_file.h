// Reads robot files (docs/robot-file.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/robot/robot.h"

namespace prehend {

// Throws InputError that names the file, the field and the value: unknown or missing field, a joint
// that no degree of freedom drives or a degree of freedom that drives nothing, limits the wrong way
// round, a preshape outside limits, a link without triangles, a mesh that cannot be read.
Robot load_robot(const std::filesystem::path& file);

// A robot of the library by name ("barrett"), or a robot file by path.
// Throws InputError that lists the names when it is neither.
Robot find_robot(const std::string& name_or_file);

std::vector<std::string> library_robot_names();

}  // namespace prehend
