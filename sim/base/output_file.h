// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace prehend {

// Makes the folder if it is missing. Throws InputError that names it when that fails.
void make_folder(const std::filesystem::path& folder);

// Writes to a file beside it first and renames. Throws InputError that names the file.
void write_file(const std::filesystem::path& file, const std::string& content);

// So that nothing of an earlier run stays behind; whether there was such a file does not matter.
void remove_file(const std::filesystem::path& file);

}  // namespace prehend
