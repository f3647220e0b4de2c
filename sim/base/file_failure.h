// What the operating system says against a file, as an exception.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace prehend {

// Whether the name of a file is at fault, or its permissions: there is no such folder, access is
// not allowed, the name is too long. Others are failures of the machine: a full disk, a device that
// fails, too many open files.
bool is_of_the_name(const std::error_code& error);

// Throws "FILE: PROBLEM: what `error` means", as an InputError where the name is at fault, else as
// std::system_error.
[[noreturn]] void throw_file_failure(const std::filesystem::path& file, const std::string& problem,
                                     const std::error_code& error);

}  // namespace prehend
