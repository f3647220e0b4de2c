// Robots, scenes and test procedures that come with prehend, by name.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace prehend {

// A folder of the data folder (data_folder.h). It is looked for at each call: a file of one's own
// needs no library, which may be missing.
class DataLibrary {
 public:
  // The entries are `folder`/NAME`suffix`: ("scenes", ".json") or ("robots", "/robot.json").
  DataLibrary(std::filesystem::path folder, std::string suffix);

  // In alphabetical order.
  std::vector<std::string> names() const;
  // The file of an entry, whether or not there is one.
  std::filesystem::path file(const std::string& name) const;
  // The path as it is where there is such a file, else the file of the entry of that name. Throws
  // InputError that lists the names when it is neither, and calls an entry `what` ("scene").
  std::filesystem::path find(const std::string& name_or_file, const std::string& what) const;

 private:
  std::filesystem::path folder_;
  std::string suffix_;
};

}  // namespace prehend
