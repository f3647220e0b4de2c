#include "sim/base/input_file.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "sim/base/file_failure.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

constexpr const char* kUnreadable = "cannot be read";

constexpr std::size_t kStartOfText = 512;  // bytes that tell what a file is

[[noreturn]] void refuse_to_read(const std::filesystem::path& file, const std::string& why) {
  throw InputError({.file = file.string(), .problem = std::string(kUnreadable) + ": " + why});
}

std::uintmax_t size_of_regular(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  // A missing file also sets `error`, so it is asked for first.
  if (status.type() == std::filesystem::file_type::not_found) refuse_to_read(file, "no such file");
  if (error) throw_file_failure(file, kUnreadable, error);
  if (std::filesystem::is_directory(status)) refuse_to_read(file, "is a folder");
  if (!std::filesystem::is_regular_file(status)) refuse_to_read(file, "is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) throw_file_failure(file, kUnreadable, error);
  return size;
}

// Files that are not what their names say, and what to do about it; empty: none of them.
std::string mistaken_for(std::string_view bytes) {
  if (bytes.starts_with("version https://git-lfs.github.com/spec/")) {
    return "a pointer of Git LFS stands for the file: fetch the file with git lfs pull";
  }
  std::string start(bytes.substr(0, std::min<std::size_t>(bytes.size(), kStartOfText)));
  start.erase(0, std::min(start.find_first_not_of(" \t\r\n"), start.size()));
  for (char& c : start) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (start.starts_with("<!doctype html") || start.starts_with("<html")) {
    return "a web page stands for the file: download the file itself (raw)";
  }
  return {};
}

// The byte order mark of UTF-8 says nothing, and readers of most formats stumble over it.
void drop_byte_order_mark(std::string& bytes) {
  const std::string_view start = std::string_view(bytes).substr(0, kStartOfText);
  if (start.starts_with("\xEF\xBB\xBF") && start.find('\0') == start.npos) bytes.erase(0, 3);
}

}  // namespace

bool is_plain_name(const std::filesystem::path& file) {
  const std::string& name = file.native();
  return std::none_of(name.begin(), name.end(), [](char c) {
    constexpr char kDelete = 0x7F;
    return static_cast<unsigned char>(c) < 0x20 || c == kDelete;
  });
}

void require_plain_name(const std::filesystem::path& file) {
  require(is_plain_name(file),
          {.file = file.string(), .problem = "the name of the file has a control character"});
}

std::string read_file(const std::filesystem::path& file) {
  require_plain_name(file);
  const std::uintmax_t size = size_of_regular(file);
  if (size == 0) refuse_to_read(file, "the file is empty");
  if (size > kLargestInputFile) {
    refuse_to_read(file, "larger than 1 GiB (" + std::to_string(size) + " bytes)");
  }
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  const auto fail = [&] {
    throw_file_failure(file, kUnreadable, {errno != 0 ? errno : EIO, std::generic_category()});
  };
  if (!stream) fail();
  std::string bytes(static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!stream) fail();
  drop_byte_order_mark(bytes);
  if (const std::string what = mistaken_for(bytes); !what.empty()) refuse_to_read(file, what);
  return bytes;
}

bool is_there(const std::filesystem::path& name) {
  std::error_code unknown;
  return is_plain_name(name) && std::filesystem::exists(name, unknown);
}

bool is_file(const std::filesystem::path& name) {
  std::error_code unknown;
  return is_plain_name(name) && std::filesystem::is_regular_file(name, unknown);
}

}  // namespace prehend
