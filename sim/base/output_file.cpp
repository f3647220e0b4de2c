#include "sim/base/output_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <streambuf>
#include <unistd.h>
#include <utility>
#include <vector>

#include "sim/base/file_failure.h"
#include "sim/base/host_name.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"

namespace prehend {
namespace {

constexpr const char* kUnwritable = "cannot be written";

[[noreturn]] void refuse(const std::filesystem::path& file, const std::string& problem) {
  throw InputError({.file = file.string(), .problem = problem});
}

std::error_code last_error() { return {errno, std::generic_category()}; }

constexpr const char* kPart = ".part";

// The end of the names of this machine's parts: on a file system that machines share, the id of a
// process says nothing about those of others.
std::string machine() { return "@" + host_name(); }

// A name beside `target`, since a rename is atomic only within one file system: of this process
// and this machine, because several may write the same target, and with a number, because threads
// may.
std::filesystem::path part_of(const std::filesystem::path& target) {
  static std::atomic<unsigned> count = 0;
  std::filesystem::path part = target;
  part += kPart + std::to_string(::getpid()) + "." + std::to_string(count++) + machine();
  return part;
}

// A link stays, and what it points to is written.
std::filesystem::path behind_link(const std::filesystem::path& name) {
  std::error_code unlinked;
  const bool is_link = std::filesystem::is_symlink(name, unlinked);
  return is_link ? std::filesystem::weakly_canonical(name, unlinked) : name;
}

// Removes what killed programs left of earlier attempts to write `target`: its parts, whose names
// have the id of a process of this machine that is gone.
void remove_old_parts(const std::filesystem::path& target) {
  const std::string prefix = target.filename().string() + kPart;
  const std::string suffix = machine();
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  std::error_code ignored;
  for (std::filesystem::directory_iterator at(folder, ignored), end; at != end;
       at.increment(ignored)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(suffix)) continue;
    if (name.size() <= prefix.size() + suffix.size()) continue;
    std::string id = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    id.resize(std::min(id.size(), id.find('.')));
    const bool is_number =
        !id.empty() && id.size() < 10 &&
        std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (!is_number) continue;
    const bool is_gone = ::kill(std::atoi(id.c_str()), 0) != 0 && errno == ESRCH;
    std::error_code also_ignored;
    if (is_gone) std::filesystem::remove_all(at->path(), also_ignored);
  }
}

// A temporary file, open for writing; its end removes it unless it was renamed. What it throws
// names the target.
class Part : public std::streambuf {
 public:
  explicit Part(const std::filesystem::path& target) : target_(target) {
    // A part of this name may be there, of a process that had the same id.
    do {
      part_ = part_of(target);
      file_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (file_ < 0 && errno == EEXIST);
    if (file_ < 0) fail(last_error());
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  ~Part() override {
    if (file_ >= 0) ::close(file_);
    std::error_code ignored;
    if (!is_renamed_) std::filesystem::remove(part_, ignored);
  }

  // All is on the disk before the name is: a machine that stops may otherwise keep the name only.
  void finish(const std::filesystem::file_status& earlier) {
    write_out();
    std::error_code error;
    if (std::filesystem::exists(earlier)) {
      std::filesystem::permissions(part_, earlier.permissions(), error);
    }
    if (error) fail(error);
    // Some file systems have no such call.
    if (::fsync(file_) != 0 && errno != EINVAL && errno != ENOTSUP) fail(last_error());
    // A full disk may be told only now; the descriptor is gone in any case.
    if (::close(std::exchange(file_, -1)) != 0) fail(last_error());
    std::filesystem::rename(part_, target_, error);
    if (error) fail(error);
    is_renamed_ = true;
  }

 protected:
  int_type overflow(int_type c) override {
    write_out();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  int sync() override {
    write_out();
    return 0;
  }

 private:
  [[noreturn]] void fail(const std::error_code& error) const {
    throw_file_failure(target_, kUnwritable, error);
  }

  void write_out() {
    const auto count = static_cast<std::size_t>(pptr() - pbase());
    if (const std::error_code error = write_all(file_, {pbase(), count})) fail(error);
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }

  const std::filesystem::path target_;
  std::filesystem::path part_;
  std::array<char, std::size_t{1} << 16U> buffer_{};
  int file_ = -1;
  bool is_renamed_ = false;
};

// The same for a folder, whose former folder is moved aside where the two cannot be exchanged.
class PartFolder {
 public:
  explicit PartFolder(const std::filesystem::path& target) : target_(target) {
    std::error_code error;
    do {
      part_ = part_of(target);
    } while (!std::filesystem::create_directory(part_, error) && !error);
    if (error) throw_file_failure(target_, kUnwritable, error);
  }
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;
  ~PartFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(part_, ignored);
  }

  const std::filesystem::path& path() const { return part_; }

  // Other processes may do the same meanwhile: what one of them has put there is replaced.
  void take_place() {
    while (true) {
      std::error_code error;
      std::filesystem::rename(part_, target_, error);
      if (!error) return;
      if (error != std::errc::directory_not_empty && error != std::errc::file_exists) fail(error);
      if (::renameat2(AT_FDCWD, part_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) {
        return;  // and the former folder is removed as the temporary one would be
      }
      const std::error_code unexchanged = last_error();
      if (unexchanged == std::errc::no_such_file_or_directory) continue;
      if (unexchanged != std::errc::invalid_argument &&
          unexchanged != std::errc::function_not_supported) {
        fail(unexchanged);
      }
      if (take_place_in_steps()) return;
    }
  }

 private:
  [[noreturn]] void fail(const std::error_code& error) const {
    throw_file_failure(target_, kUnwritable, error);
  }

  // False where another process was faster.
  bool take_place_in_steps() {
    const std::filesystem::path former = part_of(target_);
    std::error_code error;
    std::filesystem::rename(target_, former, error);
    if (error == std::errc::no_such_file_or_directory) return false;
    if (error) fail(error);
    std::filesystem::rename(part_, target_, error);
    std::error_code ignored;
    if (error) {
      std::filesystem::rename(former, target_, ignored);
      if (error != std::errc::directory_not_empty && error != std::errc::file_exists) fail(error);
    }
    std::filesystem::remove_all(former, ignored);
    return !error;
  }

  const std::filesystem::path target_;
  std::filesystem::path part_;
};

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
  constexpr const char* kProblem = "cannot make this folder";
  require_plain_name(folder);
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw_file_failure(folder, kProblem, error);
  if (!std::filesystem::is_directory(folder, error)) refuse(folder, kProblem);
}

std::error_code write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return last_error();
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return {};
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
  const std::filesystem::path target = behind_link(file);
  std::error_code error;
  const std::filesystem::file_status earlier = std::filesystem::status(target, error);
  // A rename would replace a device or a folder's entry by a file.
  if (std::filesystem::exists(earlier) && !std::filesystem::is_regular_file(earlier)) {
    refuse(file, std::string(kUnwritable) + ": is not a regular file");
  }
  remove_old_parts(target);
  Part part(target);
  std::ostream stream(&part);
  stream.exceptions(std::ios::badbit);
  write(stream);
  part.finish(earlier);
}

void write_folder(const std::filesystem::path& folder,
                  const std::function<void(const std::filesystem::path&)>& write) {
  require_plain_name(folder);
  const std::filesystem::path target = behind_link(folder);
  remove_old_parts(target);
  PartFolder part(target);
  write(part.path());
  part.take_place();
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
