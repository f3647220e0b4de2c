#include "sim/base/data_folder.h"

#include <cstdlib>
#include <dlfcn.h>
#include <link.h>
#include <string>
#include <system_error>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

namespace fs = std::filesystem;

constexpr const char* kVariable = "PREHEND_DATA";
constexpr int kMostAncestors = 5;

bool has_robots(const fs::path& folder) {
  std::error_code unreadable;
  return fs::is_directory(folder / "robots", unreadable);
}

// The binary that contains this code. For a shared library the dynamic loader knows its path. For
// the program itself it does not (dladdr would return argv[0], which need not be a path), so the
// kernel is asked (/proc/self/exe). Symbolic links are resolved: a link to an installed program
// finds the data of that installation.
fs::path this_binary() {
  Dl_info info;
  link_map* loaded = nullptr;
  const auto* here = reinterpret_cast<const void*>(&data_folder);
  const bool known = dladdr1(here, &info, reinterpret_cast<void**>(&loaded), RTLD_DL_LINKMAP) != 0;
  const bool is_program = !known || loaded == nullptr || *loaded->l_name == '\0';
  const fs::path file = is_program ? "/proc/self/exe" : loaded->l_name;
  std::error_code unreadable;
  const fs::path real = fs::canonical(file, unreadable);
  return unreadable ? file : real;
}

}  // namespace

std::optional<fs::path> find_data_folder() {
  if (const char* named = std::getenv(kVariable); named != nullptr && *named != '\0') {
    if (has_robots(named)) return named;
    throw InputError({.field = kVariable, .problem = "no folder robots in it", .value = named});
  }
  fs::path folder = this_binary().parent_path();
  for (int above = 0; above <= kMostAncestors; ++above, folder = folder.parent_path()) {
    fs::path data = folder / "share" / "prehend";
    if (has_robots(data)) return data;
  }
  return std::nullopt;
}

fs::path data_folder() {
  if (auto found = find_data_folder()) return *std::move(found);
  throw InputError({.file = "share/prehend",
                    .problem = "the robots and scenes that come with prehend are missing, no such "
                               "folder in or above " +
                               this_binary().parent_path().string() + "; " + kVariable +
                               " can name one"});
}

}  // namespace prehend
