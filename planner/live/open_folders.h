// The folders whose files a session may read and write.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/json/json_field.h"

namespace prehend {

// Commands of a session may come from other programs and machines, so that the files they name are
// looked for in these folders only. What comes with prehend (scenes and robots of the library) is
// always open.
class OpenFolders {
 public:
  OpenFolders() = default;  // none
  // Throws InputError for a folder that is not there.
  explicit OpenFolders(const std::vector<std::filesystem::path>& folders);

  // The absolute path of a file to read or write; a relative name is looked for in the first
  // folder. Links are followed before the path is compared. Throws InputError of `field` for a
  // path outside of all folders.
  std::filesystem::path path_of(const std::string& name, const std::string& field) const;

  // A robot or a platform: a name of the library as it is, that of a file as path_of.
  std::string robot_of(const std::string& name, const std::string& field) const;

  // Looks through a scene file for files that it names: of meshes, robots and platforms. Relative
  // names stand beside the file. Throws InputError as path_of.
  void check_scene(const JsonField& root) const;

 private:
  bool is_open(const std::filesystem::path& file) const;

  std::vector<std::filesystem::path> folders_;  // canonical
};

}  // namespace prehend
