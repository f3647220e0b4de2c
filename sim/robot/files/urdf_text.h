// Robots and platforms as URDF (docs/reference/urdf-files.md).
#pragma once

#include <filesystem>
#include <vector>

#include "sim/robot/files/robot_text.h"
#include "sim/robot/platform.h"

namespace prehend {

// The platform as the URDF file `name`, the meshes of its links in a folder beside it, and a
// sidecar file with what URDF has no words for. Frames of links are those after their joints,
// couplings are written as mimic joints, Denavit-Hartenberg joints as a joint and a fixed one. It
// reads back with equal positions of all links for equal joint values: poses to rounding, meshes in
// single precision. Names of a platform of several robots are ROBOT_NAME; all but the hand read
// back as one robot, the arm. Throws InputError for a robot whose joints are no tree.
std::vector<RobotTextFile> urdf_text(const Platform& platform, const std::filesystem::path& name);

}  // namespace prehend
