// What this process has used.
#pragma once

#include <ctime>
#include <fstream>
#include <string>

namespace prehend::benchmark {

// Time of all threads on processors [s].
inline double processor_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Processor time of a call, all threads together [ms]. Unlike a wall clock it hardly depends on
// what else the machine does.
template <typename Call>
double processor_milliseconds(const Call& call) {
  const double start = processor_seconds();
  call();
  return 1e3 * (processor_seconds() - start);
}

// The most memory that was resident since forget_most_megabytes (Linux; 0 elsewhere) [MB].
inline double most_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kibibytes = 0.0;
    if (word == "VmHWM:" && status >> kibibytes) return 1.024e-3 * kibibytes;
  }
  return 0.0;
}

inline void forget_most_megabytes() { std::ofstream("/proc/self/clear_refs") << "5"; }

}  // namespace prehend::benchmark
