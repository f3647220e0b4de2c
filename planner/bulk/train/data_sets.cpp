#include "planner/bulk/train/data_sets.h"

#include <algorithm>

#include "sim/base/input_error.h"

namespace prehend {

std::vector<std::filesystem::path> data_set_files(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& path : paths) {
    require(std::filesystem::exists(path), {.file = path.string(), .problem = "does not exist"});
    if (!std::filesystem::is_directory(path)) {
      files.push_back(path);
      continue;
    }
    std::vector<std::filesystem::path> inside;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
      if (entry.is_regular_file() && entry.path().extension() == ".h5") {
        inside.push_back(entry.path());
      }
    }
    std::sort(inside.begin(), inside.end());
    files.insert(files.end(), inside.begin(), inside.end());
  }
  require(!files.empty(), {.field = "sets", .problem = "there is no data set (.h5) in it"});
  return files;
}

}  // namespace prehend
