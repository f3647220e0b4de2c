// Which process it was, when only its number is left: numbers are used again.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <sys/types.h>

namespace prehend {

struct ProcessMark {
  std::string host;
  std::string boot;  // the kernel's name for the time since it started
  int pid = 0;
  std::uint64_t started = 0;  // clock ticks after the start of the kernel
};

// The mark of a running process; nothing when there is none.
std::optional<ProcessMark> mark_of(pid_t pid);

enum class ProcessState {
  running,
  gone,
  elsewhere,  // its machine is another one: not known
};

ProcessState state_of(const ProcessMark& mark);

}  // namespace prehend
