#include "sim/base/output_file.h"

#include <cerrno>
#include <fstream>
#include <unistd.h>

#include "sim/base/input_error.h"

namespace prehend {

void make_folder(const std::filesystem::path& folder) {
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
  // In the same folder as the target, because a rename is atomic only within one file system; with
  // the process id, because two programs may write the same file.
  std::filesystem::path part = file;
  part += ".part" + std::to_string(::getpid());
  errno = 0;
  std::ofstream stream(part, std::ios::binary);
  stream << content;
  stream.close();  // errors such as a full disk may appear only when the buffer is flushed
  std::error_code error;
  if (!stream) error.assign(errno != 0 ? errno : EIO, std::generic_category());
  if (stream) std::filesystem::rename(part, file, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw InputError({.file = file.string(), .problem = "cannot be written: " + error.message()});
}

void remove_file(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

}  // namespace prehend
