// The data sets that learning reads.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "planner/datasets/grasp_set.h"

namespace prehend {

// Reads one file of a data set.
using GraspSetReader = std::function<GraspSet(const std::filesystem::path& file)>;

// The files among `paths`, and of each folder among them those that end in .h5, also in the folders
// inside it, in the order of their paths. Throws InputError for a path that is not there, and where
// there is no file.
std::vector<std::filesystem::path> data_set_files(const std::vector<std::filesystem::path>& paths);

// The reader of files of data sets (.h5); empty where this prehend has none.
GraspSetReader data_set_reader();

}  // namespace prehend
