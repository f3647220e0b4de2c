// Sets of grasps as one table of comma separated values, a row a grasp
// (docs/reference/datasets.md).
#pragma once

#include <ostream>
#include <string>

#include "planner/results/datasets/grasp_set.h"

namespace prehend {

// The names of the columns, as a line.
void write_grasp_table_header(std::ostream& stream);

// The grasps of a set that is called `name`. Nothing is kept between two sets. Throws InputError as
// require_sound (grasp_set_checks.h), before anything is written.
void write_grasp_table_rows(std::ostream& stream, const std::string& name, const GraspSet& set);

}  // namespace prehend
