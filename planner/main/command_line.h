// The words after "prehend": the command they ask for, with its options.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "planner/main/commands.h"

namespace prehend {

// What a command may use.
struct Limits {
  std::string budget = {};   // wall-clock time, such as 2s; empty: no limit
  std::uint64_t memory = 0;  // address space in MB, 0: no limit
};

class CommandLine {
 public:
  CommandLine();
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  // Reads the words. False where they asked for help or the version, which is then printed. Throws
  // InputError.
  bool read(int argc, char** argv);

  const Limits& limits() const;

  // The commands that return what they have begin no more work at the end of the budget; where that
  // is not enough, or for the other commands, it acts like an interrupt. Throws InputError.
  void limit_time(Interrupts& interrupts);

  // Runs the command that was read: the program's exit status.
  int run(Interrupts& interrupts) const;

 private:
  struct Options;
  std::unique_ptr<Options> words_;
};

}  // namespace prehend
