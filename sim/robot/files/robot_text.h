// Robots and platforms as text of our own format (docs/reference/robot-file.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/robot/platform.h"

namespace prehend {

// A file to be written: its name, relative to a folder, and its content.
struct RobotTextFile {
  std::filesystem::path name;
  std::string content;
};

// The robot as a robot file, in metres, radians and kilograms, with the meshes of its links as
// lists of triangles. It reads back as the same robot, apart from its notes: axes and directions
// to rounding, all else to the bit; links that follow a joint stand behind those of the joints
// before it. Throws InputError for a robot whose joints are no tree.
std::string robot_text(const Robot& robot);

// The platform as files: one of a platform of one robot, else the platform file `name` and a file
// of each robot, called after both: for arm.json, arm_hand.json.
std::vector<RobotTextFile> platform_text(const Platform& platform,
                                         const std::filesystem::path& name);

}  // namespace prehend
