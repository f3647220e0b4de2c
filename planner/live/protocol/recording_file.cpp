#include "planner/live/protocol/recording_file.h"

#include <cerrno>
#include <fcntl.h>
#include <string_view>
#include <system_error>
#include <unistd.h>

#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

std::string last_error() { return std::error_code(errno, std::generic_category()).message(); }

// Whether all was written; errno says why not.
bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

RecordingFile::RecordingFile(const std::filesystem::path& file) : file_(file) {
  require_writable(std::filesystem::absolute(file).parent_path());
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) return;
  throw InputError({.field = "--record",
                    .problem = "cannot be written: " + last_error(),
                    .value = file.string()});
}

RecordingFile::~RecordingFile() { ::close(descriptor_); }

void RecordingFile::add(const std::string& line) {
  if (problem_.empty() && !write_all(descriptor_, line + "\n")) {
    problem_ = "the recording has ended: " + last_error();
    // A device or a pipe keeps what it was given.
    if (::ftruncate(descriptor_, size_) != 0) problem_ += "; its last line is not whole";
  }
  require(problem_.empty(), {.file = file_.string(), .problem = problem_});
  size_ += static_cast<std::int64_t>(line.size()) + 1;
}

}  // namespace prehend
