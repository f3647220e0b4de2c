// A library that is loaded before the others (LD_PRELOAD) into a program under test, and has the
// system refuse a call by which that writes a file, or has a signal arrive there. Calls are counted
// over the process, from 1: those that open a file for writing, write to it, flush or close it, and
// those that rename or make files and folders.
//
//   FAIL_CALL    the number of the call that fails; 0: none
//   FAIL_HOW     full: it and all later ones, of a full disk, and the first half of what it was to
//                write is written; broken: it alone, of a broken disk; kill, term, int: it goes
//                well, but a signal comes before it
//                apart: none fails, but folders cannot be exchanged, as on a network's file system
//   FAIL_REPORT  file that says at the end how many calls there were, and at once which call failed
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace {

enum class How { full, broken, kill, term, interrupt, apart };

std::string_view text_of(const char* variable) {
  const char* value = std::getenv(variable);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

How asked_how() {
  const std::string_view how = text_of("FAIL_HOW");
  if (how == "full") return How::full;
  if (how == "broken") return How::broken;
  if (how == "apart") return How::apart;
  if (how == "kill") return How::kill;
  return how == "term" ? How::term : How::interrupt;
}

// By calls that are not counted.
void report(const std::string& text) {
  const std::string_view file = text_of("FAIL_REPORT");
  if (file.empty()) return;
  const long opened =
      ::syscall(SYS_openat, AT_FDCWD, file.data(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::syscall(SYS_write, opened, text.data(), text.size());
  ::syscall(SYS_close, opened);
}

class Calls {
 public:
  // Whether the call is to fail; errno then says why. `halved` is set where half of it is to be
  // done first.
  bool fails(const char* name, bool* halved = nullptr) {
    const long number = ++count_;
    if (number < asked_ || asked_ == 0 || how_ == How::apart) return false;
    if (number == asked_) report(name);
    if (how_ == How::full) {
      if (number == asked_ && halved != nullptr) {
        *halved = true;
        return false;
      }
      errno = ENOSPC;
      return true;
    }
    if (number > asked_) return false;
    if (how_ == How::broken) {
      errno = EIO;
      return true;
    }
    if (how_ == How::kill) ::kill(::getpid(), SIGKILL);
    ::kill(::getpid(), how_ == How::term ? SIGTERM : SIGINT);
    return false;
  }

  bool are_apart() const { return how_ == How::apart; }

  ~Calls() {
    if (asked_ == 0) report(std::to_string(count_));
  }

  // Files that were opened for writing.
  static constexpr int kMost = 1024;
  std::atomic<bool> writes[kMost] = {};

 private:
  const long asked_ = std::atol(std::string(text_of("FAIL_CALL")).c_str());
  const How how_ = asked_how();
  std::atomic<long> count_ = 0;
};

Calls& calls() {
  static Calls made;
  return made;
}

// The programs that one under test starts are left alone.
bool is_tested() {
  static const bool is = std::string_view(program_invocation_short_name) == "prehend";
  return is;
}

bool is_written(int file) {
  return is_tested() && file >= 0 && file < Calls::kMost && calls().writes[file];
}

template <typename Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int open_file(int folder, const char* name, int flags, mode_t mode) {
  const bool is_writing = is_tested() && (flags & O_ACCMODE) != O_RDONLY;
  if (is_writing && calls().fails("open")) return -1;
  const int file = static_cast<int>(::syscall(SYS_openat, folder, name, flags, mode));
  if (is_writing && file >= 0 && file < Calls::kMost) calls().writes[file] = true;
  return file;
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & O_CREAT) != 0 ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

}  // namespace

// The parameters have names that say what they are, unlike those of the C library.
// NOLINTBEGIN(readability-inconsistent-declaration-parameter-name)
extern "C" {

int open(const char* name, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_file(AT_FDCWD, name, flags, mode);
}

int open64(const char* name, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_file(AT_FDCWD, name, flags, mode);
}

ssize_t write(int file, const void* bytes, size_t count) {
  bool halved = false;
  if (is_written(file) && calls().fails("write", &halved)) return -1;
  return ::syscall(SYS_write, file, bytes, halved ? (count + 1) / 2 : count);
}

int fsync(int file) {
  if (is_written(file) && calls().fails("fsync")) return -1;
  return static_cast<int>(::syscall(SYS_fsync, file));
}

int close(int file) {
  const bool counts = is_written(file);
  if (counts) calls().writes[file] = false;
  const int status = static_cast<int>(::syscall(SYS_close, file));
  return counts && calls().fails("close") ? -1 : status;
}

int rename(const char* from, const char* to) noexcept {
  if (is_tested() && calls().fails("rename")) return -1;
  return next<int (*)(const char*, const char*)>("rename")(from, to);
}

int renameat2(int from_folder, const char* from, int to_folder, const char* to,
              unsigned flags) noexcept {
  if (is_tested() && calls().fails("renameat2")) return -1;
  if (is_tested() && calls().are_apart()) {
    errno = EINVAL;
    return -1;
  }
  return static_cast<int>(::syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
}

int mkdir(const char* name, mode_t mode) noexcept {
  if (is_tested() && calls().fails("mkdir")) return -1;
  return static_cast<int>(::syscall(SYS_mkdir, name, mode));
}

int link(const char* from, const char* to) noexcept {
  if (is_tested() && calls().fails("link")) return -1;
  return static_cast<int>(::syscall(SYS_link, from, to));
}

ssize_t sendfile(int to, int from, off_t* offset, size_t count) noexcept {
  if (is_written(to) && calls().fails("sendfile")) return -1;
  return ::syscall(SYS_sendfile, to, from, offset, count);
}

}  // extern "C"
// NOLINTEND(readability-inconsistent-declaration-parameter-name)
