// Output files and folders; files are written atomically.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>

namespace prehend {

// Throws InputError that names the folder unless files could be written to it: it, or where it is
// missing the nearest of its parents that exists, is a folder with permission to write. Creates
// nothing. For a program that would otherwise find out after its work.
void require_writable(const std::filesystem::path& folder);

// What the functions below throw for what cannot be written: InputError that names the file where
// its name is at fault, or its permissions; std::system_error, whose text names it as well, for a
// failure of the machine, such as a full disk (throw_file_failure).

// Creates the folder and its parents if they are missing.
void make_folder(const std::filesystem::path& folder);

// Writes `content` to a temporary file in the same folder, then renames that to `file`, so that
// other processes see either the old or the complete new file, and so does the next start of a
// machine that loses its power. Any number of threads, processes and machines may write the same
// file. A file that was there keeps its permissions, a symbolic link keeps pointing to the file
// that is written. Temporary files that killed programs left are removed. A name that stands for
// something else than a regular file is refused.
void write_file(const std::filesystem::path& file, const std::string& content);
// The same for content that is made while it is written, and never in memory as a whole. What
// `write` throws is passed on, and the file is left as it was. The stream throws where it fails.
void write_file(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

// The same for a folder with all its files, which `write` makes in the temporary folder that it is
// given. An earlier folder of the name is removed with all that it holds once the new one has taken
// its place. That is one step where the file system can exchange two folders; where it cannot, the
// folder is missing for a moment.
void write_folder(const std::filesystem::path& folder,
                  const std::function<void(const std::filesystem::path&)>& write);

// Writes all bytes to an open file, or returns what the system says against it; some are written
// then.
std::error_code write_all(int descriptor, std::string_view bytes);

// Removes the file, for instance one that an earlier run left. Does nothing where there is none;
// other errors are ignored.
void remove_file(const std::filesystem::path& file);

// Removes the regular files of the folder whose names `chosen` accepts; links, also those to such
// files, and folders stay. Errors are ignored.
void remove_regular_files(const std::filesystem::path& folder,
                          const std::function<bool(const std::string& name)>& chosen);

}  // namespace prehend
