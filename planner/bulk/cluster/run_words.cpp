#include "planner/bulk/cluster/run_words.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

// What a child begins with: its files, and signals that are neither ignored nor held back, unlike
// those of this program.
class ChildStart {
 public:
  explicit ChildStart(short flags) {
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawnattr_init(&attributes);
    sigset_t signals{};
    ::sigemptyset(&signals);
    ::posix_spawnattr_setsigmask(&attributes, &signals);
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM}) ::sigaddset(&signals, signal);
    ::posix_spawnattr_setsigdefault(&attributes, &signals);
    ::posix_spawnattr_setflags(
        &attributes, static_cast<short>(flags | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF));
    ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  }
  ~ChildStart() {
    ::posix_spawn_file_actions_destroy(&files);
    ::posix_spawnattr_destroy(&attributes);
  }
  ChildStart(const ChildStart&) = delete;
  ChildStart& operator=(const ChildStart&) = delete;

  posix_spawn_file_actions_t files{};
  posix_spawnattr_t attributes{};
};

pid_t spawn(std::vector<std::string> words, const ChildStart& start) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, pointers[0], &start.files, &start.attributes,
                                   pointers.data(), environ);
  if (error == ENOENT) throw InputError({.field = words[0], .problem = "is not installed here"});
  if (error != 0) {
    throw InputError(
        {.field = words[0], .problem = std::string("cannot be started: ") + std::strerror(error)});
  }
  return child;
}

// The two ends of a pipe, which children do not inherit.
class Pipe {
 public:
  explicit Pipe(const std::string& program) {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) {
      throw InputError({.field = program, .problem = "cannot be started: too many open files"});
    }
  }
  ~Pipe() {
    ::close(ends_[0]);
    close_end();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int from() const { return ends_[0]; }
  int to() const { return ends_[1]; }
  void close_end() {
    if (ends_[1] >= 0) ::close(ends_[1]);
    ends_[1] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

// Adds what there is to `text`. False at the end.
bool read_some(int file, std::string& text) {
  std::array<char, 4096> bytes{};
  const ssize_t count = ::read(file, bytes.data(), bytes.size());
  if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
  return count > 0 || (count < 0 && errno == EINTR);
}

void read_both(int out, int err, Finished& finished) {
  std::array<pollfd, 2> files{pollfd{out, POLLIN, 0}, pollfd{err, POLLIN, 0}};
  while (files[0].fd >= 0 || files[1].fd >= 0) {
    if (::poll(files.data(), files.size(), -1) < 0 && errno != EINTR) return;
    if (files[0].revents != 0 && !read_some(out, finished.out)) files[0].fd = -1;
    if (files[1].revents != 0 && !read_some(err, finished.err)) files[1].fd = -1;
    files[0].revents = 0;
    files[1].revents = 0;
  }
}

int status_of(pid_t child) {
  int raw = 0;
  while (::waitpid(child, &raw, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

Finished run_words(const std::vector<std::string>& words) {
  Pipe out(words[0]);
  Pipe err(words[0]);
  ChildStart start(0);
  ::posix_spawn_file_actions_adddup2(&start.files, out.to(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&start.files, err.to(), STDERR_FILENO);
  const pid_t child = spawn(words, start);
  out.close_end();
  err.close_end();
  Finished finished;
  read_both(out.from(), err.from(), finished);
  finished.status = status_of(child);
  return finished;
}

std::string printed_by(const std::vector<std::string>& words) {
  Finished finished = run_words(words);
  if (finished.status == 0) return std::move(finished.out);
  const std::string said = first_line(finished.err.empty() ? finished.out : finished.err);
  throw InputError({.field = words[0], .problem = said.empty() ? "failed without a word" : said});
}

pid_t start_detached(const std::vector<std::string>& words, const std::filesystem::path& log) {
  ChildStart start(POSIX_SPAWN_SETSID);
  ::posix_spawn_file_actions_addopen(&start.files, STDOUT_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_APPEND, 0644);
  ::posix_spawn_file_actions_adddup2(&start.files, STDOUT_FILENO, STDERR_FILENO);
  return spawn(words, start);
}

}  // namespace prehend
