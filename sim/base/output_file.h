// Files that are written whole or not at all.
#pragma once

#include <filesystem>
#include <string>

namespace prehend {

// Makes the folder if it is missing. Throws InputError that names it when that fails.
void make_folder(const std::filesystem::path& folder);

// Writes to a temporary file in the same folder and renames that, so that readers see the old file
// or the new one, never a part. Throws InputError that names the file.
void write_file(const std::filesystem::path& file, const std::string& content);

// Removes what an earlier run left under this name; fine where there is no such file.
void remove_file(const std::filesystem::path& file);

}  // namespace prehend
