// The command `batch` and those below it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "planner/bulk/merge_batch.h"
#include "planner/main/command_line.h"
#include "planner/main/commands.h"

namespace prehend {

// Arguments of `batch` and of the commands below it that work on the same folder.
struct BatchCommand {
  std::filesystem::path file;  // batch file
  std::string shard = "1/1";
  bool retry = false;  // parts that failed
  MergeOptions merge;
  CommonOptions common;  // out: empty: out/NAME, of the batch
};

// Declares `batch`, `batch merge` and `batch status`. Once one of them is read, `choose` is called
// with what runs it, which refers to `command`. Returns `batch`.
CLI::App& add_batch(CLI::App& app, BatchCommand& command, Limits& limits,
                    const std::function<void(std::function<int(Interrupts&)>)>& choose);

// Each prints to stdout and returns the exit status. Throws InputError for a caller's mistake,
// before anything is written. Interrupted, `batch` keeps the parts that are done.
int run_batch(const BatchCommand& command, Interrupts& interrupts);
int run_batch_merge(const BatchCommand& command, Interrupts& interrupts);
int run_batch_status(const BatchCommand& command, Interrupts& interrupts);

}  // namespace prehend
