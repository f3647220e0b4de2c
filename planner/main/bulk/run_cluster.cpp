#include <iostream>

#include "planner/bulk/cluster/cluster_job.h"
#include "planner/bulk/cluster/cluster_words.h"
#include "planner/bulk/cluster/submit_job.h"
#include "planner/main/bulk/bulk_commands.h"
#include "planner/main/bulk/requested_batch.h"
#include "planner/main/shared_options.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

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

// The value of an option that has words for a number; nothing where the option is not there.
std::optional<int> number_of(const std::string& words, int (*read)(const std::string&),
                             const std::string& option) {
  if (words.empty()) return std::nullopt;
  try {
    return read(words);
  } catch (const InputError& error) {
    throw error.about(option, words);
  }
}

std::filesystem::path absolute_path(const std::filesystem::path& path) {
  return path.empty() ? path : std::filesystem::absolute(path).lexically_normal();
}

// Without a slash at its end, so that names of files can be added.
std::filesystem::path absolute_folder(const std::filesystem::path& path) {
  const std::filesystem::path folder = absolute_path(path);
  return folder.has_filename() ? folder : folder.parent_path();
}

// The program that started this one.
std::filesystem::path this_prehend() {
  return std::filesystem::read_symlink("/proc/self/exe").replace_filename("prehend");
}

ClusterJob asked_job(const SubmitCommand& command) {
  return {.engine = engine_named(command.engine),
          .name = command.name,
          .program = command.program.empty() ? this_prehend() : absolute_path(command.program),
          .batch = absolute_path(command.batch),
          .out = absolute_folder(command.out),
          .shards = command.shards,
          .cores = command.cores,
          .at_once = command.at_once,
          .merge = !command.no_merge,
          .memory = number_of(command.memory, slurm_megabytes, "--memory"),
          .time_limit = number_of(command.time, slurm_seconds, "--time"),
          .partition = command.partition,
          .account = command.account,
          .hosts = absolute_path(command.hosts),
          .extra_lines = command.extra_lines};
}

// The scripts as one that can be given to the engine by hand: the first ends before the second
// begins.
void print_scripts(const ClusterJob& job) {
  std::cout << job_script(job);
  if (job.engine == ClusterEngine::slurm && job.merge) {
    std::cout << "\n# What merges, in a job of its own after this one:\n" << merge_script(job);
  }
}

std::string what_was_submitted(const SubmittedJob& job) {
  if (job.process) return "GNU parallel, process " + std::to_string(job.process->pid);
  std::string text = "Slurm job " + job.ids.front();
  if (job.ids.size() > 1) text += ", then " + job.ids[1] + ", which merges";
  return text;
}

void add_out(CLI::App& command, std::filesystem::path& out) {
  command.add_option("-o,--out", out, "folder of the batch, on all machines the same")->required();
}

void add_sizes(CLI::App& command, SubmitCommand& submit) {
  const CLI::Range positive(1, 1000000);
  command.add_option("--shards", submit.shards, "parts of the batch that run by themselves")
      ->check(positive)
      ->required();
  command.add_option("--cores", submit.cores, "processors of each shard")
      ->check(positive)
      ->capture_default_str();
  command.add_option("--at-once", submit.at_once, "shards at once; of parallel, on each machine")
      ->check(positive);
  command.add_option("--memory", submit.memory, "of each shard, such as 4G (slurm; 4G)");
  command.add_option(
      "--time", submit.time,
      "of each shard before it has to start again: minutes, 4:00:00 or 2-12 (slurm)");
  command.add_option("--partition", submit.partition, "where to run (slurm)");
  command.add_option("--account", submit.account, "who pays (slurm)");
}

void declare(CLI::App& command, SubmitCommand& submit) {
  add_examples(command,
               {"batch submit batch.json --dry-run", "batch submit batch.json --engine parallel"});
  command.add_option("batch", submit.batch, "file of the batch")->required();
  add_out(command, submit.out);
  command.add_option("--engine", submit.engine, "what runs them: slurm or parallel")
      ->check(CLI::IsMember({"slurm", "parallel"}))
      ->capture_default_str();
  add_sizes(command, submit);
  command.add_option("--hosts", submit.hosts, "machines to run on by ssh (parallel)");
  command.add_option("--name", submit.name, "of the job")->capture_default_str();
  command.add_option("--program", submit.program, "prehend on those machines; without, this one");
  command
      .add_option("--line", submit.extra_lines,
                  "one more line of the script, #SBATCH or a command; may be repeated")
      ->take_all()
      ->expected(1);
  command.add_flag("--no-merge", submit.no_merge, "do not merge the parts when all are done");
  command.add_flag("--dry-run", submit.dry_run, "print the scripts and submit nothing");
}

void declare(CLI::App& command, JobCommand& job) { add_out(command, job.out); }

int run_submit(const SubmitCommand& command, Interrupts& /*interrupts*/) {
  const ClusterJob job = asked_job(command);
  // What no shard could run is refused here, once.
  const AskedBatch asked(job.batch, job.out);
  if (command.dry_run) {
    print_scripts(job);
    return 0;
  }
  asked.folder.create();
  const SubmittedJob submitted = submit_job(job);
  std::cout << "submitted " << job.shards << " shards: " << what_was_submitted(submitted) << "\n";
  return 0;
}

int run_cancel(const JobCommand& command, Interrupts& /*interrupts*/) {
  const bool was_alive = cancel_job(absolute_folder(command.out));
  std::cout << (was_alive ? "cancelled: what is done stays, submit goes on from there\n"
                          : "the job has ended already\n");
  return 0;
}

int run_queue(const JobCommand& command, Interrupts& /*interrupts*/) {
  const std::optional<JobStatus> status = cluster_status(absolute_folder(command.out));
  std::cout << (status ? status_text(*status) : "no job was submitted from this folder\n");
  return 0;
}

}  // namespace

void add_cluster_commands(CLI::App& batch, CommandRequest& request) {
  add_unlimited_command(batch, request, "submit", "give the shards of a batch to a cluster",
                        declare, run_submit);
  add_examples(add_unlimited_command(batch, request, "cancel", "take a submitted batch back",
                                     declare, run_cancel),
               {"batch cancel --out out/batch"});
  add_examples(add_unlimited_command(batch, request, "queue", "say how far a submitted batch is",
                                     declare, run_queue),
               {"batch queue --out out/batch"});
}

}  // namespace prehend
