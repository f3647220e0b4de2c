#include "sim/robot/files/package_folders.h"

#include <charconv>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string_view>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"

namespace prehend {
namespace {

using Path = std::filesystem::path;

// What follows `scheme` in `uri`.
std::optional<std::string> after(std::string_view scheme, const std::string& uri) {
  if (!uri.starts_with(scheme)) return std::nullopt;
  return uri.substr(scheme.size());
}

// %20 is a blank, as in addresses of the web; what is no such code stays.
std::string percent_decoded(const std::string& text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    const char* const first = text.data() + i + 1;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(first, first + 2, code, 16).ptr == first + 2) {
      decoded += static_cast<char>(code);
      i += 2;
    } else {
      decoded += text[i];
    }
  }
  return decoded;
}

// The folder of `file` and those above it.
std::vector<Path> folders_above(const Path& file) {
  std::vector<Path> folders;
  Path folder = std::filesystem::absolute(file).lexically_normal().parent_path();
  for (;;) {
    folders.push_back(folder);
    const Path above = folder.parent_path();
    if (above == folder) return folders;
    folder = above;
  }
}

std::vector<Path> folders_of_environment() {
  std::vector<Path> folders;
  const char* list = std::getenv("ROS_PACKAGE_PATH");
  if (!list) return folders;
  std::istringstream words(list);
  for (std::string word; std::getline(words, word, ':');) {
    if (!word.empty()) folders.emplace_back(word);
  }
  return folders;
}

Path in_package(const std::string& uri, const std::string& rest, const Path& from,
                const PackageFolders& packages) {
  const std::size_t slash = rest.find('/');
  if (slash == 0 || slash == std::string::npos || slash + 1 == rest.size()) {
    throw InputError({.problem = "must name a package and a file in it", .value = uri});
  }
  const std::string name = rest.substr(0, slash);
  const std::string inside = rest.substr(slash + 1);
  if (const auto said = packages.find(name); said != packages.end()) {
    if (is_file(said->second / inside)) return said->second / inside;
    throw InputError({.problem = "is not in " + said->second.string(), .value = uri});
  }
  for (const Path& folder : folders_above(from)) {
    if (is_file(folder / name / inside)) return folder / name / inside;
    // The folder may be that of the package under another name.
    if (is_file(folder / inside)) return folder / inside;
  }
  for (const Path& folder : folders_of_environment()) {
    if (is_file(folder / name / inside)) return folder / name / inside;
    if (folder.filename() == name && is_file(folder / inside)) return folder / inside;
  }
  throw InputError({.problem = "not found in or above the folder of the file, nor in "
                               "ROS_PACKAGE_PATH; say where its package is with --package " +
                               name + "=FOLDER",
                    .value = uri});
}

}  // namespace

Path resolved_uri(const std::string& uri, const Path& from, const PackageFolders& packages) {
  // What $(find PACKAGE) of xacro becomes behind file://.
  if (uri.starts_with("file://package://")) return resolved_uri(uri.substr(7), from, packages);
  for (const char* scheme : {"package://", "model://"}) {
    if (const auto rest = after(scheme, uri)) {
      return in_package(uri, percent_decoded(*rest), from, packages);
    }
  }
  const Path path = after("file://", uri).value_or(uri);
  const Path file = path.is_absolute() ? path : from.parent_path() / path;
  const std::string decoded = percent_decoded(uri);
  if (!is_file(file) && decoded != uri) return resolved_uri(decoded, from, packages);
  if (!is_file(file))
    throw InputError(
        {.problem = "no such file: it must be there, relative to this one", .value = uri});
  return file;
}

}  // namespace prehend
