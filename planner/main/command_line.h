// The words after "prehend": the command they ask for, with its options. Each command stands in a
// file of its own, run_NAME.cpp, with its options, how they are declared and what it does; those of
// prehend-live and prehend-bulk (other_programs.h) in the folders live and bulk.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "planner/main/interrupts.h"

namespace CLI {  // NOLINT(readability-identifier-naming): that of CLI11
class App;
}

namespace prehend {

// What a command may use.
struct Limits {
  std::string budget = {};   // wall-clock time, such as 2s; empty: no limit
  std::uint64_t memory = 0;  // address space in MB, 0: no limit
};

// What a command line asks for.
struct CommandRequest {
  Limits limits = {};
  // Prints to stdout and returns the exit status. Throws InputError for a caller's mistake, before
  // anything is written. Interrupted, `plan` writes the grasps that it has found, `batch` keeps the
  // parts that are done, and the others end at once. At the end of the budget `plan` and `evaluate`
  // write all files about what was tried until then.
  std::function<int(Interrupts&)> run = {};
};

// Declares the commands of a program below `app`.
using AddCommands = std::function<void(CLI::App& app, CommandRequest& request)>;

// Reads the words by the commands that `add` declares. Nothing where they ask for help or the
// version, which is then printed. Throws InputError.
std::optional<CommandRequest> read_command_line(int argc, char** argv, const AddCommands& add);

// Each declares a command below `app`, which sets request.run once it is read.
void add_plan(CLI::App& app, CommandRequest& request);
void add_evaluate(CLI::App& app, CommandRequest& request);
void add_path(CLI::App& app, CommandRequest& request);
void add_together(CLI::App& app, CommandRequest& request);
void add_simulate(CLI::App& app, CommandRequest& request);
void add_render(CLI::App& app, CommandRequest& request);
void add_inspect(CLI::App& app, CommandRequest& request);
void add_quality(CLI::App& app, CommandRequest& request);
void add_convert(CLI::App& app, CommandRequest& request);

}  // namespace prehend
