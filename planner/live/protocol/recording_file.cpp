#include "planner/live/protocol/recording_file.h"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace prehend {

RecordingFile::RecordingFile(const std::filesystem::path& file) : file_(file) {
  require_writable(std::filesystem::absolute(file).parent_path());
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ >= 0) return;
  throw InputError(
      {.field = "--record",
       .problem = "cannot be written: " + std::error_code(errno, std::generic_category()).message(),
       .value = file.string()});
}

RecordingFile::~RecordingFile() { ::close(descriptor_); }

void RecordingFile::add(const std::string& line) {
  if (!error_) {
    error_ = write_all(descriptor_, line + "\n");
    // A device or a pipe keeps what it was given.
    is_whole_ = !error_ || ::ftruncate(descriptor_, size_) == 0;
  }
  if (error_) {
    throw std::system_error(error_, on_one_line(file_.string()) + ": the recording has ended" +
                                        (is_whole_ ? "" : ", its last line is not whole"));
  }
  size_ += static_cast<std::int64_t>(line.size()) + 1;
}

}  // namespace prehend
