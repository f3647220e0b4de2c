#include "planner/main/program.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <optional>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <system_error>
#include <unistd.h>

#include "planner/main/interrupts.h"
#include "planner/main/option_values.h"
#include "sim/base/file_failure.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// Exit statuses besides 0, and those of interrupted programs (Interrupts::exit_status).
constexpr int kCallersMistake = 2;
constexpr int kFailure = 1;

// What this program has mapped, its libraries as well [bytes]; 0 where the system does not say.
std::uint64_t mapped_memory() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

// Memory beyond the limit is refused from now on. Below what the program and its libraries need to
// begin, the libraries fail in ways of their own, so that is refused at once.
void limit_memory(std::uint64_t megabytes) {
  if (megabytes == 0) return;
  constexpr std::uint64_t kToBegin = std::uint64_t{8} << 20U;
  const rlim_t bytes = static_cast<rlim_t>(megabytes) << 20U;
  if (bytes < mapped_memory() + kToBegin) throw std::bad_alloc();
  const rlimit limit{bytes, bytes};
  if (::setrlimit(RLIMIT_AS, &limit) == 0) return;
  throw InputError(
      {.field = "--memory-limit", .problem = "cannot be set", .value = std::to_string(megabytes)});
}

int say(int status, const std::string& message) {
  std::cerr << "prehend: " << on_one_line(message) << "\n";
  return status;
}

int say_short_of_memory() {
  return say(kFailure,
             "not enough memory: allow more (--memory-limit), or use fewer threads (--threads)");
}

// A file that the standard library names, a thread that could not be started, ...
int say_failure(const std::system_error& error) {
  if (error.code() == std::errc::not_enough_memory ||
      error.code() == std::errc::resource_unavailable_try_again) {
    return say_short_of_memory();
  }
  if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    const std::filesystem::path& path = file->path2().empty() ? file->path1() : file->path2();
    return say(is_of_the_name(error.code()) ? kCallersMistake : kFailure,
               (path.empty() ? "" : path.string() + ": ") + error.code().message());
  }
  return say(kFailure, error.what());
}

int run(int argc, char** argv, const AddCommands& add) {
  const std::optional<CommandRequest> request = read_command_line(argc, argv, add);
  if (!request) return 0;
  // Made before any other thread, as its constructor demands.
  Interrupts interrupts;
  const Limits& limits = request->limits;
  limit_memory(limits.memory);
  if (!limits.budget.empty()) interrupts.limit_time(seconds_of(limits.budget));
  return request->run(interrupts);
}

// Whether whoever read the output has gone, as `head` does when it has seen enough. POSIX says so
// of a pipe without readers (POLLERR), never of a file.
bool reader_has_gone() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return ::poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

// Whether all that was printed arrived where somebody wanted it; it may not where it goes to a full
// disk.
bool printed_all() {
  std::cout.flush();
  const bool arrived = std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  return arrived || reader_has_gone();
}

}  // namespace

int run_program(int argc, char** argv, const AddCommands& add) {
  // Writing to a closed pipe fails then, and the command does the rest of its work; beyond the
  // largest size of files (ulimit -f) it is reported like any other lost output.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int status = run(argc, argv, add);
    if (printed_all()) return status;
    return say(status == 0 ? kFailure : status, "the standard output cannot be written");
  } catch (const InputError& error) {
    return say(kCallersMistake, error.what());
  } catch (const std::system_error& error) {
    return say_failure(error);
  } catch (const std::bad_alloc&) {
    return say_short_of_memory();
  } catch (const std::length_error&) {  // of a container that no memory could hold
    return say_short_of_memory();
  } catch (const std::exception& error) {
    return say(kFailure, std::string("internal error, please report the command and its files: ") +
                             error.what());
  }
}

}  // namespace prehend
