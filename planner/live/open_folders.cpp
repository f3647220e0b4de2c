#include "planner/live/open_folders.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"

namespace prehend {
namespace {

constexpr std::array<std::string_view, 3> kNamesOfFiles = {"mesh", "hand", "platform"};

bool names_a_file(const std::string& key) {
  return std::find(kNamesOfFiles.begin(), kNamesOfFiles.end(), key) != kNamesOfFiles.end();
}

std::filesystem::path canonical_path(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path path = std::filesystem::weakly_canonical(file, error);
  return error ? std::filesystem::path() : path;
}

}  // namespace

OpenFolders::OpenFolders(const std::vector<std::filesystem::path>& folders) {
  for (const std::filesystem::path& folder : folders) {
    std::error_code error;
    const bool is_folder = std::filesystem::is_directory(folder, error);
    require(is_folder, {.field = "folder", .problem = "no such folder", .value = folder.string()});
    folders_.push_back(canonical_path(folder));
  }
}

bool OpenFolders::is_open(const std::filesystem::path& file) const {
  return std::any_of(folders_.begin(), folders_.end(), [&](const std::filesystem::path& folder) {
    const auto end = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
    return end.first == folder.end() && end.second != file.end();
  });
}

std::filesystem::path OpenFolders::path_of(const std::string& name,
                                           const std::string& field) const {
  const std::filesystem::path given(name);
  const bool relative = given.is_relative() && !folders_.empty();
  const std::filesystem::path path = canonical_path(relative ? folders_.front() / given : given);
  require(!path.empty() && is_open(path),
          {.field = field, .problem = "not in a folder that is open", .value = name});
  return path;
}

std::string OpenFolders::robot_of(const std::string& name, const std::string& field) const {
  // find_robot takes what is a file as a file, and all else as a name of the library.
  const bool is_path = name.find('/') != std::string::npos || is_there(name);
  return is_path ? path_of(name, field).string() : name;
}

void OpenFolders::check_scene(const JsonField& root) const {
  // The fields are looked for in all places instead of in those where scene files have them now, so
  // that none is forgotten.
  std::vector<JsonField> open = {root};
  while (!open.empty()) {
    const JsonField field = open.back();
    open.pop_back();
    if (field.is_list()) {
      for (const JsonField& item : field.items()) open.push_back(item);
    } else if (field.is_object()) {
      for (const std::string& key : field.keys()) {
        const JsonField inner = field[key];
        open.push_back(inner);
        if (!names_a_file(key) || !inner.is_text()) continue;
        const std::string name = inner.text();
        const std::filesystem::path beside = field.file().parent_path() / name;
        if (is_there(beside)) {
          (void)path_of(beside.string(), inner.name());
        } else {
          (void)robot_of(name, inner.name());
        }
      }
    }
  }
}

}  // namespace prehend
