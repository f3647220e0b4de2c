// Grasps as an Isaac Grasp file (docs/reference/exports.md).
#pragma once

#include <string>
#include <vector>

#include "planner/show/exports/export_grasp.h"

namespace prehend {

// The grasps as YAML text, in the given order. Source: "What is an Isaac Grasp File?" in the
// documentation of Isaac Sim (Grasp Editor), and "Isaac Grasp File" in that of Isaac ROS. Throws
// InputError that names the grasp when it has another number of joints than the header, or a number
// is not finite.
std::string isaac_grasps_yaml(const ExportHeader& header, const std::vector<ExportGrasp>& grasps);

}  // namespace prehend
