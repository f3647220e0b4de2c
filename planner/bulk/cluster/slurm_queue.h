// What Slurm's programs say of jobs.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace prehend {

// A task of a job array, or a job that is none.
struct QueuedTask {
  std::string job;    // the id of the array, or of the job
  std::string task;   // its number in the array; "N/A": of none
  std::string state;  // as Slurm has it: PENDING, RUNNING, ...
  int restarts = 0;
};

// The tasks of the jobs that squeue knows, those that ended a while ago not among them. Throws
// InputError when Slurm cannot be asked.
std::vector<QueuedTask> queued_tasks(const std::vector<std::string>& ids);

// Whether a task in this state waits or runs, or will again.
bool is_queued_state(const std::string& state);

// How many tasks of the array ended in which state, by Slurm's accounting; nothing where that is
// off.
std::optional<std::map<std::string, int>> ended_tasks(const std::string& id);

// What squeue and sacct print, for the functions above; for tests.
std::vector<QueuedTask> parse_queue(const std::string& printed);
std::map<std::string, int> parse_accounting(const std::string& printed);

}  // namespace prehend
