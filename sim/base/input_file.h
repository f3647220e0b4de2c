// Reads input files whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace prehend {

// Input files are held in memory as a whole, so larger ones are refused [bytes].
inline constexpr std::uintmax_t kLargestInputFile = std::uintmax_t{1} << 30;

// The bytes of a regular file. Throws InputError that names the file and says why it cannot be
// read: there is none, no permission, a name that is too long or not plain, a folder, a device or a
// FIFO (which might never end), an empty file (also those of /proc, whose size is not known
// before), or one larger than kLargestInputFile. Throws std::system_error for a failure of the
// machine (throw_file_failure).
std::string read_file(const std::filesystem::path& file);

// Whether a name has no control characters. What is behind a NUL the system does not see, and lines
// of messages and lists end at line breaks. Files of other names are neither found, read nor
// written (output_file.h).
bool is_plain_name(const std::filesystem::path& file);
// Throws InputError that names the file unless it has such a name.
void require_plain_name(const std::filesystem::path& file);

// Whether something of this name is there, and whether it is a regular file. False also when that
// cannot be found out: of a name that is too long or not plain, or in a folder that may not be
// searched.
bool is_there(const std::filesystem::path& name);
bool is_file(const std::filesystem::path& name);

}  // namespace prehend
