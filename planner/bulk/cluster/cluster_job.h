// A batch as a job of a cluster: what is asked of it, and the scripts that run it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/named_enum.h"

namespace prehend {

// What hands the shards of a batch to processors.
enum class ClusterEngine {
  slurm,     // sbatch: one job array, a task for each shard
  parallel,  // GNU parallel, on this machine or over ssh
};

constexpr auto enum_names(ClusterEngine /*of*/) {
  return std::to_array<std::string_view>({"slurm", "parallel"});
}
// Throws InputError for any other name.
ClusterEngine engine_named(const std::string& name);

// The shards 1 to `shards` of a batch, each run by
//   PROGRAM batch BATCH -o OUT --shard I/N --threads CORES
// which goes on where it was stopped, whenever that was, and then, if wanted, merged by
//   PROGRAM batch merge BATCH -o OUT
// Paths are absolute and the same on all machines.
struct ClusterJob {
  ClusterEngine engine = ClusterEngine::slurm;
  std::string name = "prehend";  // letters, digits and . _ - only, like partition and account
  std::filesystem::path program = {};
  std::filesystem::path batch = {};  // the file of the batch
  std::filesystem::path out = {};
  int shards = 1;                   // >= 1
  int cores = 1;                    // of each shard, >= 1
  std::optional<int> at_once = {};  // shards that run at once, with parallel on each machine, >= 1
  bool merge = true;
  // Of Slurm only.
  std::optional<int> memory = {};      // of each shard [MB], > 0; empty: kUsualMemory
  std::optional<int> time_limit = {};  // of each shard [s], > 0; empty: the partition's
  std::string partition = {};          // empty: the usual one; also of account
  std::string account = {};
  // Of parallel only: its file of ssh hosts (--sshloginfile); empty: this machine.
  std::filesystem::path hosts = {};
  // For the scripts as they stand: of Slurm more lines "#SBATCH ...", of both commands such as
  // "module load gcc", which run before the program.
  std::vector<std::string> extra_lines = {};
};

inline constexpr int kUsualMemory = 4096;  // [MB]

// How often GNU parallel runs a shard that fails before it gives the shard up.
inline constexpr int kParallelTries = 3;

// How often Slurm may have started a shard when it reaches its time limit and still starts again.
inline constexpr int kMostStarts = 100;

// Throws InputError, whose field is the member, for values out of range, relative paths, control
// characters, and what the engine does not have.
void check_cluster_job(const ClusterJob& job);

// The script that runs the shards: for sbatch, or for bash, which then also merges. Whatever stands
// in its paths is taken as it is. Throws as check_cluster_job.
std::string job_script(const ClusterJob& job);

// The script for sbatch that merges. Throws as check_cluster_job.
std::string merge_script(const ClusterJob& job);

// Where what the shards say goes, "NUMBER.txt" each; it has to be there before the job starts.
std::filesystem::path log_folder(const std::filesystem::path& out);

}  // namespace prehend
