// The words after "prehend": the command they ask for, with its options. Each command stands in a
// file of its own, run_NAME.cpp, with its options, how they are declared and what it does.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "planner/main/interrupts.h"

namespace CLI {
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

// Nothing where the words ask for help or the version, which is then printed. Throws InputError.
std::optional<CommandRequest> read_command_line(int argc, char** argv);

// Each declares a command below `app`, which sets request.run once it is read.
void add_plan(CLI::App& app, CommandRequest& request);
void add_evaluate(CLI::App& app, CommandRequest& request);
void add_simulate(CLI::App& app, CommandRequest& request);
void add_render(CLI::App& app, CommandRequest& request);
void add_inspect(CLI::App& app, CommandRequest& request);
void add_quality(CLI::App& app, CommandRequest& request);
void add_validate(CLI::App& app, CommandRequest& request);
void add_convert(CLI::App& app, CommandRequest& request);
void add_learn(CLI::App& app, CommandRequest& request);
void add_replay(CLI::App& app, CommandRequest& request);
void add_serve(CLI::App& app, CommandRequest& request);
void add_studio(CLI::App& app, CommandRequest& request);
void add_batch(CLI::App& app, CommandRequest& request);
// submit, cancel and queue, below `batch`.
void add_cluster_commands(CLI::App& batch, CommandRequest& request);

}  // namespace prehend
