// Grasps and paths as tables of comma separated values (docs/reference/exports.md).
#pragma once

#include <string>
#include <vector>

#include "planner/show/exports/export_grasp.h"

namespace prehend {

// grasps.csv: one row a grasp. Throws InputError that names the grasp when it has another number of
// dofs or joints than the header, or a number is not finite.
std::string grasps_csv(const ExportHeader& header, const std::vector<ExportGrasp>& grasps);

// "path_RANK.csv", which the column "path" of grasps.csv names.
std::string path_file_name(int rank);

// The path as text, one row a sample: time, segment, positions and velocities. A sample that two
// segments share belongs to the earlier one.
std::string path_csv(const Trajectory& path);

}  // namespace prehend
