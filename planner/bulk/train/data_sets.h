// The data sets that learning reads.
#pragma once

#include <filesystem>
#include <vector>

namespace prehend {

// The files among `paths`, and of each folder among them those that end in .h5, also in the folders
// inside it, in the order of their paths. Throws InputError for a path that is not there, and where
// there is no file.
std::vector<std::filesystem::path> data_set_files(const std::vector<std::filesystem::path>& paths);

}  // namespace prehend
