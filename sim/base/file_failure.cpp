#include "sim/base/file_failure.h"

#include <algorithm>
#include <array>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

constexpr std::array kOfTheName = {std::errc::no_such_file_or_directory,
                                   std::errc::not_a_directory,
                                   std::errc::is_a_directory,
                                   std::errc::permission_denied,
                                   std::errc::operation_not_permitted,
                                   std::errc::read_only_file_system,
                                   std::errc::filename_too_long,
                                   std::errc::too_many_symbolic_link_levels,
                                   std::errc::invalid_argument,
                                   std::errc::file_exists};

}  // namespace

bool is_of_the_name(const std::error_code& error) {
  return std::any_of(kOfTheName.begin(), kOfTheName.end(),
                     [&](std::errc code) { return error == code; });
}

void throw_file_failure(const std::filesystem::path& file, const std::string& problem,
                        const std::error_code& error) {
  if (is_of_the_name(error)) {
    throw InputError({.file = file.string(), .problem = problem + ": " + error.message()});
  }
  throw std::system_error(error, on_one_line(file.string() + ": " + problem));
}

}  // namespace prehend
