// Gives a batch to a cluster, asks what became of it, and takes it back.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "planner/bulk/cluster/cluster_job.h"
#include "planner/bulk/cluster/submitted_job.h"

namespace prehend {

// Writes the scripts of the job and then job.json into its folder, and gives it to Slurm, or starts
// GNU parallel, which goes on by itself. Throws InputError for what check_cluster_job refuses, when
// a job of this folder still waits or runs, when the engine is not installed or refuses the job
// (its first line says why), and when the folder cannot be written.
SubmittedJob submit_job(const ClusterJob& job);

// How far a job is.
struct JobStatus {
  SubmittedJob job;
  // Shards by state, such as pending, running, completed, failed: of Slurm its own words in small
  // letters, those that ended only as long as Slurm remembers them.
  std::map<std::string, int> shards = {};
  int started_again = 0;  // of the shards of Slurm that wait or run: after preemption, say
  // Whether anything of it may still run, the merge included.
  bool is_alive = false;
  std::string merge = {};  // of Slurm: the state of the merge; empty: none, or forgotten
};

// Of the job of the folder; nothing where none was submitted. Throws InputError when the engine
// cannot be asked.
std::optional<JobStatus> cluster_status(const std::filesystem::path& out);

// The same as a line or two for people, each with its end.
std::string status_text(const JobStatus& status);

// Takes the job of the folder back: what waits does not start, what runs is stopped. Returns
// whether there was anything to stop. Throws InputError where no job was submitted, or it runs on
// another machine or does not stop.
bool cancel_job(const std::filesystem::path& out);

}  // namespace prehend
