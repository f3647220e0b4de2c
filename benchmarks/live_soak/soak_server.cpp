// Lets clients that try everything talk to a live server for long, and judges what it answers.
//   live_soak [--messages N] [--hours H] [--clients N] [--seed S]
// Prints each kind of fault with the first request that showed it, and the resident memory in each
// quarter. Exit status 1 after a fault, or where memory grows by more than 5 % after the
// first quarter (under sanitizers it does: they keep what was freed).
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/live_soak/live_soak.h"
#include "planner/live/serve/few_heaps.h"

namespace {

using prehend::live_soak::LiveSoakOptions;
using prehend::live_soak::LiveSoakResult;

constexpr double kMostGrowth = 0.05;

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*signal*/) { interrupted = 1; }

LiveSoakOptions read_arguments(int argc, char** argv) {
  LiveSoakOptions options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    if (i + 1 >= argc) throw std::invalid_argument(name + " needs a value");
    const std::string value = argv[i + 1];
    if (name == "--messages") {
      options.messages = std::stol(value);
    } else if (name == "--hours") {
      options.seconds = 3600.0 * std::stod(value);
    } else if (name == "--clients") {
      options.clients = std::stoi(value);
    } else if (name == "--seed") {
      options.seed = std::stoull(value);
    } else {
      throw std::invalid_argument("unknown option " + name);
    }
  }
  return options;
}

void print_line(const LiveSoakResult& result) {
  std::printf(
      "%ld messages: %ld carried out, %ld refused; %d undone, %d unchanged, %d evaluated (%d "
      "stable, %d at edges)\n",
      result.messages(), result.carried_out, result.refused, result.undone, result.unchanged,
      result.evaluated, result.stable, result.at_edges);
  std::fflush(stdout);
}

int print(const LiveSoakResult& result) {
  print_line(result);
  for (const auto& [words, fault] : result.faults) {
    std::printf("FAULT %s (%d times): %s\n", words.c_str(), fault.count, fault.first.c_str());
  }
  std::vector<std::pair<long, std::string>> refusals;
  for (const auto& [words, count] : result.refusals) refusals.emplace_back(count, words);
  std::sort(refusals.rbegin(), refusals.rend());
  refusals.resize(std::min<std::size_t>(refusals.size(), 15));
  for (const auto& [count, words] : refusals)
    std::printf("refused %ld times: %s\n", count, words.c_str());
  for (const double megabytes : result.quarters()) std::printf("%.1f MB\n", megabytes);
  std::printf("memory after the first quarter: %+.1f %%\n", 100.0 * result.growth());
  return result.faults.empty() && result.growth() <= kMostGrowth ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    prehend::use_few_heaps();
    LiveSoakOptions options = read_arguments(argc, argv);
    for (const int signal : {SIGINT, SIGTERM}) (void)std::signal(signal, interrupt);
    options.interrupted = [] { return interrupted != 0; };
    options.progress = [next = 0L](const LiveSoakResult& result) mutable {
      if (result.messages() < next) return;
      print_line(result);
      next = result.messages() + 5000;
    };
    return print(prehend::live_soak::run_live_soak(options));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "live_soak: %s\n", error.what());
    return 2;
  }
}
