// The program while it runs: a test reads what it says and interrupts it.
#pragma once

#include <algorithm>
#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <iterator>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

namespace prehend::test {

// Its stdout goes to the file `out` of the folder. No file of it becomes larger than `largest_file`
// bytes.
class RunningProgram {
 public:
  RunningProgram(const std::vector<std::string>& words, const std::filesystem::path& folder,
                 rlim_t largest_file = RLIM_INFINITY) {
    int ends[2] = {-1, -1};
    if (::pipe(ends) != 0) ADD_FAILURE() << "no pipe";
    pid_ = ::fork();
    if (pid_ == 0) {
      ::dup2(ends[1], STDERR_FILENO);
      ::close(ends[0]);
      ::close(ends[1]);
      const int out = ::open((folder / "out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
      ::dup2(out, STDOUT_FILENO);
      std::vector<char*> arguments = {const_cast<char*>(PREHEND_PROGRAM)};
      for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
      arguments.push_back(nullptr);
      rlimit limit{};
      ::getrlimit(RLIMIT_FSIZE, &limit);
      limit.rlim_cur = std::min(limit.rlim_max, largest_file);
      ::setrlimit(RLIMIT_FSIZE, &limit);
      ::execv(PREHEND_PROGRAM, arguments.data());
      ::_exit(127);
    }
    ::close(ends[1]);
    stderr_ = ends[0];
  }
  ~RunningProgram() {
    if (pid_ > 0) {
      ::kill(pid_, SIGKILL);
      ::waitpid(pid_, nullptr, 0);
    }
    ::close(stderr_);
  }
  RunningProgram(const RunningProgram&) = delete;
  RunningProgram& operator=(const RunningProgram&) = delete;

  // Reads lines of stderr until one starts so; false when the program ends before.
  bool wait_for_line(const std::string& start) {
    while (true) {
      std::string line = next_line();
      if (line.empty()) return false;
      if (line.starts_with(start)) return true;
    }
  }

  // Waits until the program has this many threads; false when it ends before.
  bool wait_for_threads(std::ptrdiff_t count) const {
    const std::filesystem::path tasks = "/proc/" + std::to_string(pid_) + "/task";
    while (!has_ended()) {
      std::error_code ignored;
      if (std::distance(std::filesystem::directory_iterator(tasks, ignored), {}) >= count) {
        return true;
      }
      ::usleep(1000);
    }
    return false;
  }

  bool has_ended() const {
    siginfo_t info{};
    ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
    return info.si_pid == pid_;
  }

  void send(int signal) const { ::kill(pid_, signal); }

  // The rest of stderr, and then the exit status; -1 when a signal ended it.
  int wait(std::string& rest) {
    rest.clear();
    for (std::string line = next_line(); !line.empty(); line = next_line()) rest += line;
    int raw = 0;
    ::waitpid(pid_, &raw, 0);
    pid_ = -1;
    return WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
  }

 private:
  // With its end; empty at the end of the stream.
  std::string next_line() const {
    std::string line;
    char c = 0;
    while (::read(stderr_, &c, 1) == 1) {
      line += c;
      if (c == '\n') break;
    }
    return line;
  }

  pid_t pid_ = -1;
  int stderr_ = -1;
};

}  // namespace prehend::test
