#include "planner/output_file.h"

#include <fstream>
#include <unistd.h>

#include "sim/geometry/input_error.h"

namespace prehend {

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder)) {
    throw InputError(folder.string() + ": cannot make this folder" +
                     (error ? " (" + error.message() + ")" : ""));
  }
}

void write_file(const std::filesystem::path& file, const std::string& content) {
  std::filesystem::path part = file;
  part += ".part" + std::to_string(::getpid());
  std::ofstream stream(part, std::ios::binary);
  stream << content;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(part, file, error);
  if (stream && !error) return;
  std::error_code ignored;
  std::filesystem::remove(part, ignored);
  throw InputError(file.string() + ": cannot be written");
}

void remove_file(const std::filesystem::path& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

}  // namespace prehend
