// Reads platforms: several robots, or a robot file as a platform of one
// (docs/reference/robot-file.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/robot/files/package_folders.h"
#include "sim/robot/platform.h"

namespace prehend {

class JsonFile;  // sim/base/json/json_field.h

// A robot file, or a file with "robots", or one in another program's format (foreign_robot.h).
// Throws InputError that names the file, the field and the
// value: a robot that is not there or stands on one that comes later, an unknown chain, a name used
// twice.
Platform load_platform(const std::filesystem::path& file, const ForeignRobotOptions& options = {});
// As load_platform, of a file that was parsed already.
Platform read_platform(const JsonFile& file);

// A platform or robot of the library by name ("obelix"), or a file by path.
// Throws InputError that lists the names when it is neither.
Platform find_platform(const std::string& name_or_file, const ForeignRobotOptions& options = {});

// Files of the library with "robots".
std::vector<std::string> library_platform_names();

}  // namespace prehend
