// Sets of grasps as files of the ACRONYM data set (Eppner, Mousavian and Fox, 2021): HDF5, with a
// group of our own for what ACRONYM does not say (docs/reference/datasets.md).
#pragma once

#include <filesystem>
#include <string>

#include "planner/results/datasets/grasp_set.h"

namespace prehend {

// The bytes of the file, made in memory: the same for the same set. Throws InputError as
// require_sound (grasp_set_checks.h).
std::string acronym_bytes(const GraspSet& set);

// Reads what acronym_bytes writes, bit for bit, and files with nothing but what ACRONYM has. There
// a grasp holds where "object_in_gripper" of the quality "flex" says so, or of the only quality.
// Needed are transforms, these labels, and file and scale of the object. Throws InputError that
// names the file and the data set.
GraspSet read_acronym(const std::filesystem::path& path);
// The same of the bytes of a file of this name.
GraspSet read_acronym(const std::string& name, const std::string& bytes);

}  // namespace prehend
