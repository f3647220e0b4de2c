// Plans random cases without end, and has every result judged by means that share no code with what
// made it.
//   soak [--hours H | --cases N] [--seed S] [--first CASE]
// A case depends on the seed and its number alone: --first CASE --cases 1 repeats it. Each failure
// is one line. At the end, also after Ctrl-C, there is a table; exit status 1 after any failure.
#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <limits>
#include <stdexcept>
#include <string>
#include <unistd.h>

#include "benchmarks/soak/run_case.h"
#include "benchmarks/soak/tally.h"
#include "sim/base/data_folder.h"

namespace {

using namespace prehend::soak;  // NOLINT(google-build-using-namespace): a program of its own
using Clock = std::chrono::steady_clock;

struct Arguments {
  double hours = std::numeric_limits<double>::infinity();
  std::uint64_t cases = std::numeric_limits<std::uint64_t>::max();
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
};

volatile std::sig_atomic_t interrupted = 0;
// What a crash says, written before each case: a handler may not make text.
std::array<char, 120> last_words{};

void interrupt(int /*signal*/) { interrupted = 1; }

void crash(int signal) {
  std::size_t length = 0;
  while (last_words.at(length) != '\0') ++length;
  (void)!write(STDOUT_FILENO, last_words.data(), length);
  (void)std::signal(signal, SIG_DFL);
  (void)std::raise(signal);
}

Arguments read_arguments(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 >= argc) throw std::invalid_argument(name + " needs a value");
    const std::string value = argv[i + 1];
    if (name == "--hours") {
      arguments.hours = std::stod(value);
    } else if (name == "--cases") {
      arguments.cases = std::stoull(value);
    } else if (name == "--seed") {
      arguments.seed = std::stoull(value);
    } else if (name == "--first") {
      arguments.first = std::stoull(value);
    } else {
      throw std::invalid_argument("unknown option " + name);
    }
  }
  return arguments;
}

void print_faults(std::uint64_t seed, std::uint64_t number, const CaseFindings& findings) {
  for (const prehend::test::Fault& fault : findings.faults) {
    std::printf("FAILED --seed %llu --first %llu --cases 1: %s: %s (%s)\n",
                static_cast<unsigned long long>(seed), static_cast<unsigned long long>(number),
                fault.kind.c_str(), fault.words.c_str(), findings.words.c_str());
  }
}

Tally run(const Arguments& arguments) {
  Tally tally;
  const auto elapsed = [start = Clock::now()] {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  double next_line = 60.0;  // s
  for (std::uint64_t i = 0; i < arguments.cases && elapsed() < 3600.0 * arguments.hours; ++i) {
    const std::uint64_t number = arguments.first + i;
    std::snprintf(
        last_words.data(), last_words.size(), "CRASHED --seed %llu --first %llu --cases 1\n",
        static_cast<unsigned long long>(arguments.seed), static_cast<unsigned long long>(number));
    const CaseFindings findings = run_case(arguments.seed, number, [] { return interrupted != 0; });
    if (findings.interrupted) break;
    tally.add(number, findings);
    print_faults(arguments.seed, number, findings);
    if (arguments.cases == 1) std::printf("%s\n", findings.words.c_str());
    if (elapsed() > next_line) {
      std::printf("%.0f s: %s\n", elapsed(), tally.line().c_str());
      next_line = elapsed() + 60.0;
    }
    std::fflush(stdout);
  }
  return tally;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Arguments arguments = read_arguments(argc, argv);
    // Found once: later the program may have been replaced by another build.
    setenv("PREHEND_DATA", prehend::data_folder().c_str(), 1);
    for (const int signal : {SIGINT, SIGTERM}) (void)std::signal(signal, interrupt);
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) {
      (void)std::signal(signal, crash);
    }
    const Tally tally = run(arguments);
    std::printf("%s", tally.table().c_str());
    return tally.failed() > 0 ? 1 : 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "soak: %s\n", error.what());
    return 2;
  }
}
