#include "planner/bulk/cluster/submit_job.h"

#include <algorithm>
#include <boost/interprocess/sync/file_lock.hpp>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>

#include "planner/bulk/cluster/run_words.h"
#include "planner/bulk/cluster/slurm_queue.h"
#include "sim/base/file_failure.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/joined.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

constexpr std::chrono::milliseconds kLook{200};
constexpr int kMostLooks = 100;

std::string in_small_letters(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

// What sbatch --parsable prints: "ID" or "ID;CLUSTER".
std::string id_of(const std::string& printed) {
  const std::string id = printed.substr(0, printed.find_first_of(";\n"));
  require(!id.empty() && id.find_first_not_of("0123456789") == std::string::npos,
          {.field = "sbatch", .problem = "printed no job id", .value = printed});
  return id;
}

// The job that merges begins when all shards have ended well.
std::string submit_merge(const ClusterJob& job, const std::string& array) {
  const std::filesystem::path script = job.out / "merge.sh";
  write_file(script, merge_script(job));
  return id_of(
      printed_by({"sbatch", "--parsable", "--dependency=afterok:" + array, script.string()}));
}

SubmittedJob submit_to_slurm(const ClusterJob& job) {
  const std::filesystem::path script = job.out / "job.sh";
  SubmittedJob submitted{.engine = job.engine, .shards = job.shards};
  submitted.ids.push_back(id_of(printed_by({"sbatch", "--parsable", script.string()})));
  try {
    write_submitted_job(submitted, job);
    if (job.merge) {
      submitted.ids.push_back(submit_merge(job, submitted.ids.front()));
      write_submitted_job(submitted, job);
    }
  } catch (...) {
    run_words({"scancel", submitted.ids.front()});
    throw;
  }
  return submitted;
}

// Asks the group of processes to end, again and again: GNU parallel waits for its jobs at first,
// and stops them when it is asked once more.
void stop_group(const ProcessMark& process) {
  for (int look = 0; look < kMostLooks; ++look) {
    ::kill(-process.pid, SIGTERM);
    std::this_thread::sleep_for(kLook);
    if (::kill(-process.pid, 0) != 0) return;
  }
  throw InputError({.field = "parallel",
                    .problem = "does not stop",
                    .value = "process " + std::to_string(process.pid)});
}

SubmittedJob start_parallel(const ClusterJob& job) {
  printed_by({"parallel", "--version"});  // says whether it is there
  const std::filesystem::path log = log_folder(job.out);
  remove_file(log / "joblog");
  const pid_t pid = start_detached({"bash", (job.out / "job.sh").string()}, log / "parallel.txt");
  SubmittedJob submitted{.engine = job.engine, .shards = job.shards};
  submitted.process = mark_of(pid);
  require(submitted.process.has_value(), {.field = "parallel",
                                          .problem = "ended at once, its log says why",
                                          .value = (log / "parallel.txt").string()});
  try {
    write_submitted_job(submitted, job);
  } catch (...) {
    stop_group(*submitted.process);
    throw;
  }
  return submitted;
}

JobStatus slurm_status(const SubmittedJob& job) {
  JobStatus status{.job = job};
  std::map<std::string, int> ended;
  for (const QueuedTask& task : queued_tasks(job.ids)) {
    const bool is_queued = is_queued_state(task.state);
    status.is_alive = status.is_alive || is_queued;
    if (task.job != job.ids.front()) {
      status.merge = in_small_letters(task.state);
    } else if (!is_queued) {
      ++ended[task.state];
    } else {
      ++status.shards[in_small_letters(task.state)];
      status.started_again += task.restarts > 0 ? 1 : 0;
    }
  }
  for (const auto& [state, count] : ended_tasks(job.ids.front()).value_or(ended)) {
    status.shards[in_small_letters(state)] += count;
  }
  return status;
}

// The shards of parallel's log of jobs: a line each that ended, with its exit status in the seventh
// column and the signal that ended it in the eighth.
std::map<std::string, int> logged_shards(const std::filesystem::path& joblog) {
  std::map<int, bool> ended;  // by number; the last try counts
  std::ifstream lines(joblog);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string skipped;
    int number = 0;
    int status = 0;
    int signal = 0;
    if (!(words >> number)) continue;
    for (int column = 2; column < 7; ++column) words >> skipped;
    if (words >> status >> signal) ended[number] = status == 0 && signal == 0;
  }
  std::map<std::string, int> counts;
  for (const auto& [number, is_well] : ended) ++counts[is_well ? "completed" : "failed"];
  return counts;
}

JobStatus parallel_status(const SubmittedJob& job, const std::filesystem::path& out) {
  JobStatus status{.job = job, .shards = logged_shards(log_folder(out) / "joblog")};
  status.is_alive = state_of(*job.process) != ProcessState::gone;
  int left = job.shards;
  for (const auto& [state, count] : status.shards) left -= count;
  if (left > 0) status.shards[status.is_alive ? "running or pending" : "not done"] = left;
  return status;
}

void require_nothing_queued(const std::filesystem::path& out) {
  const std::optional<JobStatus> before = cluster_status(out);
  if (!before || !before->is_alive) return;
  const std::string which = before->job.engine == ClusterEngine::slurm
                                ? "Slurm job " + before->job.ids.front()
                                : "process " + std::to_string(before->job.process->pid) + " on " +
                                      before->job.process->host;
  throw InputError({.file = job_file(out).string(),
                    .problem = "a job of this folder still waits or runs: see batch status, or "
                               "batch cancel",
                    .value = which});
}

// Held while a job of this folder is submitted: two at once would both find nothing queued, and the
// second would make the first one unknown.
class SubmitLock {
 public:
  explicit SubmitLock(const std::filesystem::path& out) {
    const std::filesystem::path file = log_folder(out) / "submit.lock";
    // Not replaced, as write_file would do: who waits has the same file open.
    if (!std::ofstream(file, std::ios::app)) {
      throw_file_failure(file, "cannot be written",
                         std::error_code(errno, std::generic_category()));
    }
    lock_ = boost::interprocess::file_lock(file.c_str());
    require(lock_.try_lock(), {.file = out.string(),
                               .problem = "another program submits a job of this folder just now"});
  }

 private:
  boost::interprocess::file_lock lock_;  // the system gives it up with the file
};

bool cancel_parallel(const ProcessMark& process) {
  const ProcessState state = state_of(process);
  require(state != ProcessState::elsewhere,
          {.problem = "the job runs on another machine, cancel it there", .value = process.host});
  if (state == ProcessState::gone) return false;
  stop_group(process);
  return true;
}

}  // namespace

SubmittedJob submit_job(const ClusterJob& job) {
  const std::string script = job_script(job);
  require(is_file(job.batch), {.file = job.batch.string(), .problem = "there is no such file"});
  make_folder(log_folder(job.out));
  const SubmitLock lock(job.out);
  require_nothing_queued(job.out);
  write_file(job.out / "job.sh", script);
  return job.engine == ClusterEngine::slurm ? submit_to_slurm(job) : start_parallel(job);
}

std::optional<JobStatus> cluster_status(const std::filesystem::path& out) {
  const std::optional<SubmittedJob> job = read_submitted_job(out);
  if (!job) return std::nullopt;
  return job->engine == ClusterEngine::slurm ? slurm_status(*job) : parallel_status(*job, out);
}

std::string status_text(const JobStatus& status) {
  std::string text = status.job.engine == ClusterEngine::slurm
                         ? "Slurm job " + status.job.ids.front()
                         : "GNU parallel, process " + std::to_string(status.job.process->pid) +
                               " on " + status.job.process->host;
  text += status.is_alive ? ": " : " has ended: ";
  std::string counts;
  for (const auto& [state, count] : status.shards) {
    add_part(counts, std::to_string(count) + " " + state);
  }
  text += (counts.empty() ? "nothing is known of its shards any more" : counts) + " of " +
          std::to_string(status.job.shards) + " shards";
  if (status.started_again > 0) {
    text += "; " + std::to_string(status.started_again) + " of them started again";
  }
  if (!status.merge.empty()) text += "; merge " + status.merge;
  return text + "\n";
}

bool cancel_job(const std::filesystem::path& out) {
  const std::optional<SubmittedJob> job = read_submitted_job(out);
  require(job.has_value(),
          {.file = out.string(), .problem = "no job was submitted from this folder"});
  if (job->engine == ClusterEngine::parallel) return cancel_parallel(*job->process);
  const bool was_alive = slurm_status(*job).is_alive;
  if (!was_alive) return false;
  std::vector<std::string> words{"scancel"};
  words.insert(words.end(), job->ids.begin(), job->ids.end());
  printed_by(words);
  return true;
}

}  // namespace prehend
