// Output files and folders; files are written atomically.
#pragma once

#include <filesystem>
#include <string>

namespace prehend {

// Creates the folder and its parents if they are missing. Throws InputError that names the folder
// when that fails.
void make_folder(const std::filesystem::path& folder);

// Writes `content` to a temporary file in the same folder, then renames that to `file`, so that
// other processes see either the old or the complete new file. Throws InputError that names the
// file.
void write_file(const std::filesystem::path& file, const std::string& content);

// Removes the file, for instance one that an earlier run left. Does nothing where there is none;
// other errors are ignored.
void remove_file(const std::filesystem::path& file);

}  // namespace prehend
