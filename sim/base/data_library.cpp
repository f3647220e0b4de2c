#include "sim/base/data_library.h"

#include <set>
#include <utility>

#include "sim/base/data_folder.h"
#include "sim/base/file_failure.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"
#include "sim/base/nearest_name.h"

namespace prehend {

DataLibrary::DataLibrary(std::filesystem::path folder, std::string suffix)
    : folder_(std::move(folder)), suffix_(std::move(suffix)) {}

std::vector<std::string> DataLibrary::names() const {
  std::set<std::string> names;
  const std::filesystem::path folder = data_folder() / folder_;
  std::error_code error;
  std::filesystem::directory_iterator entries(folder, error);
  // A library that is not installed has no names.
  if (error && !is_of_the_name(error)) throw_file_failure(folder, "cannot be read", error);
  for (const auto& entry : entries) {
    std::string name = entry.path().filename().string();
    // What follows the name in that of the entry: nothing, where each has a folder.
    const std::string ending = suffix_.substr(0, suffix_.find('/'));
    if (!name.ends_with(ending)) continue;
    name.resize(name.size() - ending.size());
    if (is_there(file(name))) names.insert(name);
  }
  return {names.begin(), names.end()};
}

std::filesystem::path DataLibrary::file(const std::string& name) const {
  return data_folder() / folder_ / (name + suffix_);
}

std::filesystem::path DataLibrary::find(const std::string& name_or_file,
                                        const std::string& what) const {
  if (is_there(name_or_file)) return name_or_file;
  const bool is_name = name_or_file.find('/') == std::string::npos;
  if (is_name && is_there(file(name_or_file))) return file(name_or_file);
  throw InputError({.file = name_or_file,
                    .problem = "no such file, and no " + what + " of that name, " +
                               did_you_mean(name_or_file, names()) + what + "s are " +
                               joined(names())});
}

}  // namespace prehend
