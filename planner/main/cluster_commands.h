// The commands below `batch` that give a batch to a cluster.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace prehend {

// Arguments of `batch submit`.
struct SubmitCommand {
  std::filesystem::path batch;
  std::filesystem::path out;
  std::string engine = "slurm";  // or parallel
  std::string name = "prehend";
  int shards = 1;
  int cores = 1;                         // of each shard
  std::string memory;                    // of each shard, such as 4G; empty: kUsualMemory
  std::string time;                      // of each shard, as Slurm has it; empty: the partition's
  std::string partition;                 // empty: the usual one
  std::string account;                   // the same
  std::optional<int> at_once;            // shards at once
  std::filesystem::path hosts;           // of parallel: its file of ssh hosts; empty: this machine
  std::filesystem::path program;         // empty: the one that runs
  std::vector<std::string> extra_lines;  // of the scripts
  bool no_merge = false;
  bool dry_run = false;  // prints the scripts instead
};

// Arguments of `batch cancel`, and of `batch queue`.
struct JobCommand {
  std::filesystem::path out;
};

struct ClusterCommands {
  SubmitCommand submit;
  JobCommand cancel;
  JobCommand queue;
};

// Declares submit, cancel and queue below `batch`. Once one of them is read, `choose` is called
// with what runs it, which refers to `commands`.
void add_cluster_commands(CLI::App& batch, ClusterCommands& commands,
                          const std::function<void(std::function<int()>)>& choose);

// Each prints to stdout and returns the exit status. Throws InputError.
int run_submit(const SubmitCommand& command);
int run_cancel(const JobCommand& command);
int run_queue(const JobCommand& command);

}  // namespace prehend
