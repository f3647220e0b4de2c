// The memory that the process of a test takes.
#pragma once

#include <fstream>
#include <string>

namespace prehend::test {

// The most memory that this process has had, in kB.
inline long peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    long value = 0;
    if (word == "VmHWM:" && status >> value) return value;
  }
  return 0;
}

}  // namespace prehend::test
