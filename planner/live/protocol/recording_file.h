// The file of a session that is being recorded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

namespace prehend {

// Every line is in the file, or none of it, as soon as it was added: a session may end by a crash.
class RecordingFile {
 public:
  // Begins an empty file. Throws InputError of the field "--record" where that cannot be done.
  explicit RecordingFile(const std::filesystem::path& file);
  ~RecordingFile();
  RecordingFile(const RecordingFile&) = delete;
  RecordingFile& operator=(const RecordingFile&) = delete;

  // Adds a line and its end. Throws std::system_error that names the file where not all of it can
  // be written, such as on a full disk: the file then ends with the line before, and every later
  // call throws the same, since a recording without one of its lines is that of another session.
  void add(const std::string& line);

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;  // of the whole lines [bytes]
  std::error_code error_;  // why nothing more is written
  bool is_whole_ = true;   // its last line
};

}  // namespace prehend
