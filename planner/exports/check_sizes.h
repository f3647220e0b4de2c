// Lists that must be as long as the names they belong to.
#pragma once

#include "planner/exports/export_grasp.h"

namespace prehend {

// Throws InputError that names the grasp's rank when it has another number of dofs or joints than
// the header.
void check_sizes(const ExportHeader& header, const ExportGrasp& grasp);

// Throws InputError when a sample is not of the path's joints.
void check_sizes(const Trajectory& path);

}  // namespace prehend
