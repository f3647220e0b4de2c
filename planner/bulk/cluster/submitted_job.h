// What is remembered of a job that was given to a cluster: the file job.json in the folder of the
// batch.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "planner/bulk/cluster/cluster_job.h"
#include "planner/bulk/cluster/process_mark.h"

namespace prehend {

struct SubmittedJob {
  ClusterEngine engine = ClusterEngine::slurm;
  int shards = 0;
  std::vector<std::string> ids = {};        // of Slurm: that of the array, then that of the merge
  std::optional<ProcessMark> process = {};  // of parallel
};

std::filesystem::path job_file(const std::filesystem::path& out);

// Writes job.json whole, with what was asked for beside it for the reader's information. Throws
// InputError when it cannot be written.
void write_submitted_job(const SubmittedJob& submitted, const ClusterJob& job);

// Nothing where the folder has no job.json. Throws InputError that names the file when it is
// damaged.
std::optional<SubmittedJob> read_submitted_job(const std::filesystem::path& out);

}  // namespace prehend
