// Robots and meshes in another format.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/robot/files/package_folders.h"
#include "sim/robot/files/robot_text.h"

namespace prehend {

// The files that hold `source` in the format that the extension of `target` names. For .json,
// .urdf, .xrdf and .srdf, `source` is a robot or platform: a name of the library or a file that
// find_platform takes; for .obj, .stl, .ply and .off it is a mesh file. Names of the files are
// relative to the folder of `target`; the last one is `target` itself. `unit` (metres_per_unit) is
// that of a mesh file or a robot in another program's format that is read, `foreign` belongs to
// such a robot. `notes` gets what was assumed of the source. Throws InputError for a source that
// cannot be read, another extension, and a target that is the source.
std::vector<RobotTextFile> converted(const std::string& source, const std::filesystem::path& target,
                                     const std::string& unit, const ForeignRobotOptions& foreign,
                                     std::vector<std::string>& notes);

}  // namespace prehend
