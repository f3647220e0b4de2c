#include "planner/live/open_folders.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/robot/files/robot_file.h"

namespace prehend {
namespace {

constexpr std::array<std::string_view, 3> kNamesOfFiles = {"mesh", "hand", "platform"};

bool names_a_file(const std::string& key) {
  return std::find(kNamesOfFiles.begin(), kNamesOfFiles.end(), key) != kNamesOfFiles.end();
}

// Whether find_robot may take a name that is none of the library for a file. What it does not find
// it refuses with the names that there are.
bool may_be_file(const std::string& name) {
  const std::filesystem::path path(name);
  return path.has_parent_path() || path.has_extension() || is_there(path);
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
  require(is_plain_name(given),
          {.field = field, .problem = "has a control character", .value = name});
  const bool relative = given.is_relative() && !folders_.empty();
  const std::filesystem::path path = canonical_path(relative ? folders_.front() / given : given);
  require(!path.empty() && is_open(path),
          {.field = field, .problem = "not in a folder that is open", .value = name});
  return path;
}

std::string OpenFolders::robot_of(const std::string& name, const std::string& field) const {
  if (is_library_robot(name)) return name;
  const bool is_here = !folders_.empty() && is_there(folders_.front() / name);
  return is_here || may_be_file(name) ? path_of(name, field).string() : name;
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
        // In this order a scene file looks for it. Relative names are not those of commands: they
        // are not looked for in a folder that is open.
        if (is_there(beside)) {
          (void)path_of(std::filesystem::absolute(beside).string(), inner.name());
        } else if (!is_library_robot(name) && may_be_file(name)) {
          (void)path_of(std::filesystem::absolute(name).string(), inner.name());
        }
      }
    }
  }
}

}  // namespace prehend
