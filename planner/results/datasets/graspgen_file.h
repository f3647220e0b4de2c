// Sets of grasps as files of GraspGen's data set (Murali et al., 2025): JSON with poses and whether
// they hold (docs/reference/datasets.md).
#pragma once

#include <string>

#include "planner/results/datasets/grasp_set.h"

namespace prehend {

class JsonFile;  // sim/base/json/json_field.h

// The text of the file. Throws InputError as require_sound (grasp_set_checks.h).
std::string graspgen_text(const GraspSet& set);

// Whether the file is one of GraspGen's: its grasps are an object with transforms.
bool is_graspgen(const JsonFile& file);

// Reads file and scale of the object (some files do not name theirs), poses, and labels: true or
// false, 1 or 0, or a list of one of these. Other fields are not looked at. Throws InputError that
// names the file and the field.
GraspSet read_graspgen(const JsonFile& file);

}  // namespace prehend
