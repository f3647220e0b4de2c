#include "sim/base/output_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <unistd.h>
#include <vector>

#include "sim/base/host_name.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"

namespace prehend {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw InputError({.file = file.string(), .problem = problem});
}

constexpr const char* kPart = ".part";

// The end of the names of this machine's parts: on a file system that machines share, the id of a
// process says nothing about those of others.
std::string machine() { return "@" + host_name(); }

// Removes what killed programs left of earlier attempts to write `file`: its parts, whose names end
// in the id of a process of this machine that is gone.
void remove_old_parts(const std::filesystem::path& file) {
  const std::string prefix = file.filename().string() + kPart;
  const std::string suffix = machine();
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code ignored;
  for (std::filesystem::directory_iterator at(folder, ignored), end; at != end;
       at.increment(ignored)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) continue;
    if (name.size() <= prefix.size() + suffix.size()) continue;
    const std::string id = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    const bool is_number = id.size() < 10 && std::all_of(id.begin(), id.end(), [](unsigned char c) {
                             return std::isdigit(c) != 0;
                           });
    if (!is_number) continue;
    const bool is_gone = ::kill(std::atoi(id.c_str()), 0) != 0 && errno == ESRCH;
    std::error_code also_ignored;
    if (is_gone) std::filesystem::remove(at->path(), also_ignored);
  }
}

// Writes the temporary file; an error of the system is returned.
std::error_code write_part(const std::filesystem::path& part,
                           const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream stream(part, std::ios::binary);
  try {
    write(stream);
  } catch (...) {
    stream.close();
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw;
  }
  stream.close();  // errors such as a full disk may appear only when the buffer is flushed
  if (stream) return {};
  return {errno != 0 ? errno : EIO, std::generic_category()};
}

}  // namespace

void require_writable(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::path existing = std::filesystem::absolute(folder, error);
  if (error) refuse(folder, "cannot be written to: " + error.message());
  std::filesystem::file_status status = std::filesystem::status(existing, error);
  // What is missing will be made inside the nearest folder that exists.
  while (status.type() == std::filesystem::file_type::not_found && existing.has_relative_path()) {
    existing = existing.parent_path();
    status = std::filesystem::status(existing, error);
  }
  if (status.type() == std::filesystem::file_type::none) {
    refuse(folder, "cannot be written to: " + error.message());
  }
  if (!std::filesystem::is_directory(status)) {
    refuse(folder, "cannot be written to: " + existing.string() + " is not a folder");
  }
  if (::access(existing.c_str(), W_OK | X_OK) != 0) {
    const std::error_code reason(errno, std::generic_category());
    refuse(folder, "cannot be written to: " + existing.string() + ": " + reason.message());
  }
}

void make_folder(const std::filesystem::path& folder) {
  require_plain_name(folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw InputError(
        {.file = folder.string(),
         .problem = "cannot make this folder" + (error ? ": " + error.message() : "")});
  }
}

// The content is written to another file, which then takes the name of the target. The target is at
// every time either as it was or complete, also where the program is interrupted or the disk is
// full.
void write_file(const std::filesystem::path& file, const std::string& content) {
  write_file(file, [&](std::ostream& stream) { stream << content; });
}

void write_file(const std::filesystem::path& file,
                const std::function<void(std::ostream&)>& write) {
  require_plain_name(file);
  // A link stays, and what it points to is written.
  std::error_code unlinked;
  const bool is_link = std::filesystem::is_symlink(file, unlinked);
  const std::filesystem::path target =
      is_link ? std::filesystem::weakly_canonical(file, unlinked) : file;
  std::error_code error;
  const std::filesystem::file_status earlier = std::filesystem::status(target, error);
  // A rename would replace a device or a folder's entry by a file.
  if (std::filesystem::exists(earlier) && !std::filesystem::is_regular_file(earlier)) {
    refuse(file, "cannot be written: is not a regular file");
  }
  remove_old_parts(target);
  // In the same folder as the target, because a rename is atomic only within one file system; with
  // the process id and the machine, because two programs may write the same file.
  std::filesystem::path part = target;
  part += kPart + std::to_string(::getpid()) + machine();
  error = write_part(part, write);
  if (!error && std::filesystem::exists(earlier)) {
    std::filesystem::permissions(part, earlier.permissions(), error);
  }
  if (!error) std::filesystem::rename(part, target, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  refuse(file, "cannot be written: " + error.message());
}

void remove_file(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

// Names are collected first, since it is unspecified what the listing of a folder shows that
// changes meanwhile.
void remove_regular_files(const std::filesystem::path& folder,
                          const std::function<bool(const std::string& name)>& chosen) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (std::filesystem::directory_iterator at(folder, ignored), end; at != end;
       at.increment(ignored)) {
    std::error_code unreadable;
    // Of the entry itself, not of what a link points to.
    const bool is_regular =
        at->symlink_status(unreadable).type() == std::filesystem::file_type::regular;
    if (is_regular && chosen(at->path().filename().string())) files.push_back(at->path());
  }
  for (const std::filesystem::path& file : files) remove_file(file);
}

}  // namespace prehend
