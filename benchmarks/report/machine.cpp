#include "benchmarks/report/machine.h"

#include <chrono>
#include <ctime>
#include <fstream>
#include <thread>

#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

// The model of the first processor, where Linux tells it.
std::string processor_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string now_in_utc() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  return formatted("%04d-%02d-%02dT%02d:%02d:%02dZ", parts.tm_year + 1900, parts.tm_mon + 1,
                   parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

}  // namespace

Machine this_machine(const std::string& prehend, const std::string& build) {
#ifdef __clang__
  const std::string compiler = __VERSION__;
#else
  const std::string compiler = std::string("GCC ") + __VERSION__;
#endif
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  return {prehend, compiler, build, processor_model(), cores, now_in_utc()};
}

}  // namespace prehend::bench
