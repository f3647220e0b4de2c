// Robots in the formats of other programs, all of them XML, told apart by the outermost element.
#pragma once

#include <filesystem>
#include <optional>

#include "sim/robot/files/package_folders.h"
#include "sim/robot/platform.h"

namespace prehend {

// Whether the file's name is one of such formats: .urdf, .xacro, .sdf, .world, .mjcf or .xml, in
// upper or lower case.
bool has_foreign_robot_name(const std::filesystem::path& file);

// The robot of a file in another program's format (docs/reference/urdf-files.md,
// docs/reference/graspit-files.md): of a hand on an arm, a platform of two robots, else a platform
// of one. A hand has Robot::hand only where the sidecar file says it. Nothing for a file that is
// not XML (its first character is not
// "<"). Throws InputError "FILE: line 12, <joint>: problem (VALUE)", also for an outermost element
// that belongs to no robot.
std::optional<Platform> read_foreign_robot(const std::filesystem::path& file,
                                           const ForeignRobotOptions& options = {});

// The robot of `platform` that is asked for where one robot is meant: the only one, or the last,
// the hand, with a note that the arm is left out.
Robot robot_alone(Platform platform);

}  // namespace prehend
