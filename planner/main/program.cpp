#include "planner/main/program.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <new>
#include <optional>
#include <string>
#include <sys/resource.h>

#include "planner/main/interrupts.h"
#include "planner/main/option_values.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// Exit statuses besides 0, and those of interrupted programs (Interrupts::exit_status).
constexpr int kCallersMistake = 2;
constexpr int kFailure = 1;

// Memory beyond the limit is refused from now on, which ends the program with "out of memory".
void limit_memory(std::uint64_t megabytes) {
  if (megabytes == 0) return;
  const rlim_t bytes = static_cast<rlim_t>(megabytes) << 20U;
  const rlimit limit{bytes, bytes};
  if (::setrlimit(RLIMIT_AS, &limit) == 0) return;
  throw InputError(
      {.field = "--memory-limit", .problem = "cannot be set", .value = std::to_string(megabytes)});
}

int say(int status, const std::string& message) {
  std::cerr << "prehend: " << on_one_line(message) << "\n";
  return status;
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

// Whether all that was printed arrived; it may not where it goes to a full disk or a closed pipe.
bool printed_all() {
  std::cout.flush();
  return std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace

int run_program(int argc, char** argv, const AddCommands& add) {
  // Writing to a closed pipe fails then, and is reported like any other lost output.
  std::signal(SIGPIPE, SIG_IGN);
  // So does writing beyond the largest size that files may have (ulimit -f).
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const int status = run(argc, argv, add);
    if (printed_all()) return status;
    return say(status == 0 ? kFailure : status, "the standard output cannot be written");
  } catch (const InputError& error) {
    return say(kCallersMistake, error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    return say(kCallersMistake, error.path1().string() + ": " + error.code().message());
  } catch (const std::bad_alloc&) {
    return say(kFailure, "out of memory");
  } catch (const std::exception& error) {
    return say(kFailure, std::string("internal error: ") + error.what());
  }
}

}  // namespace prehend
