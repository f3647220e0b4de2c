#include "planner/bulk/cluster/cluster_job.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <string_view>

#include "planner/bulk/cluster/script_words.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

constexpr int kSecondsOfMinute = 60;

bool has_control(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return std::iscntrl(static_cast<unsigned char>(c)) != 0; });
}

void check_path(const std::filesystem::path& path, const std::string& field) {
  const std::string text = path.string();
  require(path.is_absolute(), {.field = field, .problem = "must be absolute", .value = text});
  require(!has_control(text),
          {.field = field, .problem = "line breaks do not fit into a script", .value = text});
}

void check_name(const std::string& name, const std::string& field) {
  const auto fits = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '_' || c == '-';
  };
  require(std::all_of(name.begin(), name.end(), fits) && !name.starts_with('-'),
          {.field = field, .problem = "must be letters, digits and . _ -", .value = name});
}

void check_number(std::optional<int> number, const std::string& field) {
  require(!number || *number >= 1,
          {.field = field, .problem = "must be at least 1", .value = std::to_string(*number)});
}

void require_slurm(bool fits, const std::string& field) {
  require(fits, {.field = field, .problem = "is of the engine slurm only"});
}

// As --time has it.
std::string slurm_time(int seconds) {
  std::array<char, 32> text{};
  const int minutes = seconds / kSecondsOfMinute;
  std::snprintf(text.data(), text.size(), "%d-%02d:%02d:%02d", minutes / 60 / 24, minutes / 60 % 24,
                minutes % 60, seconds % kSecondsOfMinute);
  return text.data();
}

std::string option_line(const std::string& option) { return "#SBATCH " + option + "\n"; }

bool is_option(const std::string& line) { return line.starts_with("#"); }

// Slurm reads options up to the first command, so those of the extra lines go before their
// commands.
std::string extra_text(const ClusterJob& job) {
  std::string options;
  std::string commands;
  for (const std::string& line : job.extra_lines) {
    (is_option(line) ? options : commands) += line + "\n";
  }
  return options + commands;
}

// What the array of shards and the job that merges have in common.
std::string common_options(const ClusterJob& job) {
  std::string text =
      option_line("--nodes=1") + option_line("--ntasks=1") +
      option_line("--cpus-per-task=" + std::to_string(job.cores)) +
      option_line("--mem=" + std::to_string(job.memory.value_or(kUsualMemory)) + "M");
  if (job.time_limit) text += option_line("--time=" + slurm_time(*job.time_limit));
  if (!job.partition.empty()) text += option_line("--partition=" + job.partition);
  if (!job.account.empty()) text += option_line("--account=" + job.account);
  return text + option_line("--requeue") + option_line("--open-mode=append");
}

std::string log_option(const ClusterJob& job, const std::string& name) {
  return option_line("--output=" + sbatch_word((log_folder(job.out) / name).string()));
}

// PROGRAM batch BATCH -o OUT, each word by `word`.
std::string command_start(const ClusterJob& job, std::string (*word)(const std::string&),
                          const std::string& verb) {
  return word(job.program.string()) + " batch " + verb + word(job.batch.string()) + " -o " +
         word(job.out.string());
}

std::string array_range(const ClusterJob& job) {
  const std::string range = "--array=1-" + std::to_string(job.shards);
  return job.at_once ? range + "%" + std::to_string(*job.at_once) : range;
}

// Before its time limit a task stops its program, which leaves whole files, and asks for another
// turn. Where it is preempted, or its node fails, Slurm does that by itself.
std::string slurm_script(const ClusterJob& job) {
  std::string text = "#!/bin/bash\n" + option_line("--job-name=" + job.name) +
                     option_line(array_range(job)) + common_options(job) +
                     option_line("--signal=B:USR1@60") + log_option(job, "%a.txt");
  // Signals may come as soon as the program runs, before its number is known here.
  text += extra_text(job) + R"(shard=
came=
near_end=
stop() { [[ -z $shard ]] || kill -TERM "$shard" 2> /dev/null; }
trap 'came=yes near_end=yes; stop' USR1
trap 'came=yes; stop' TERM
)";
  text += command_start(job, shell_word, "") + " \\\n  --shard \"$SLURM_ARRAY_TASK_ID/" +
          std::to_string(job.shards) + "\" --threads " + std::to_string(job.cores) + " &\n";
  text += R"(shard=$!
[[ -z $came ]] || stop
# A signal ends the wait before the program has ended.
came=yes
while [[ -n $came ]]; do
  came=
  wait "$shard"
  status=$?
done
)";
  text += "if [[ -n $near_end && $status != 0 ]] && ((${SLURM_RESTART_COUNT:-0} < " +
          std::to_string(kMostStarts) + ")); then\n";
  text += R"(  echo "the time limit is near: this shard starts again, and goes on from here"
  exec scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$status"
)";
  return text;
}

// A share of the processors, in percent: no more shards at once than have their cores.
std::string parallel_jobs(const ClusterJob& job) {
  if (job.at_once) return std::to_string(*job.at_once);
  return std::to_string(std::max(1, 100 / job.cores)) + "%";
}

std::string parallel_script(const ClusterJob& job) {
  const std::string log = log_folder(job.out).string();
  const std::string shard = command_start(job, parallel_word, "") + " --shard {}/" +
                            std::to_string(job.shards) + " --threads " + std::to_string(job.cores) +
                            " >> " + parallel_word(log + "/") + "{}.txt 2>&1";
  std::string text = "#!/bin/bash\n" + extra_text(job) + "export PARALLEL_SHELL=/bin/bash\n";
  text += "seq 1 " + std::to_string(job.shards) + " |\n  parallel --plain --will-cite --jobs " +
          parallel_jobs(job) + " --retries " + std::to_string(kParallelTries) + " --joblog " +
          shell_word(log + "/joblog");
  if (!job.hosts.empty()) text += " --sshloginfile " + shell_word(job.hosts.string());
  text += " \\\n  " + shell_word(shard) + " || exit\n";
  if (!job.merge) return text;
  return text + command_start(job, shell_word, "merge ") + " >> " + shell_word(log + "/merge.txt") +
         " 2>&1\n";
}

}  // namespace

ClusterEngine engine_named(const std::string& name) {
  if (const auto engine = value_named<ClusterEngine>(name)) return *engine;
  throw InputError({.field = "engine", .problem = "must be slurm or parallel", .value = name});
}

void check_cluster_job(const ClusterJob& job) {
  check_path(job.program, "program");
  check_path(job.batch, "batch");
  check_path(job.out, "out");
  check_name(job.name, "name");
  check_name(job.partition, "partition");
  check_name(job.account, "account");
  check_number(job.shards, "shards");
  check_number(job.cores, "cores");
  check_number(job.at_once, "at_once");
  check_number(job.memory, "memory");
  check_number(job.time_limit, "time_limit");
  for (const std::string& line : job.extra_lines) {
    require(!has_control(line), {.field = "extra_lines", .problem = "must be one line each"});
  }
  if (job.engine == ClusterEngine::slurm) {
    // It takes names of output files for patterns, in which the two mean something.
    require(job.out.string().find_first_of("\\%") == std::string::npos,
            {.field = "out",
             .problem = "Slurm cannot write to folders with % or a backslash in their name",
             .value = job.out.string()});
    require(job.hosts.empty(), {.field = "hosts", .problem = "are of the engine parallel only"});
    // Slurm looks every 30 s whether a signal is due, and may send it a minute early.
    require(!job.time_limit || *job.time_limit >= 5 * kSecondsOfMinute,
            {.field = "time_limit",
             .problem = "must be at least 5 minutes",
             .value = std::to_string(job.time_limit.value_or(0)) + " s"});
    return;
  }
  require_slurm(!job.memory, "memory");
  require_slurm(!job.time_limit, "time_limit");
  require_slurm(job.partition.empty(), "partition");
  require_slurm(job.account.empty(), "account");
  if (!job.hosts.empty()) check_path(job.hosts, "hosts");
}

std::string job_script(const ClusterJob& job) {
  check_cluster_job(job);
  return job.engine == ClusterEngine::slurm ? slurm_script(job) : parallel_script(job);
}

std::string merge_script(const ClusterJob& job) {
  check_cluster_job(job);
  return "#!/bin/bash\n" + option_line("--job-name=" + job.name + "-merge") + common_options(job) +
         option_line("--kill-on-invalid-dep=yes") + log_option(job, "merge.txt") + extra_text(job) +
         "exec " + command_start(job, shell_word, "merge ") + "\n";
}

std::filesystem::path log_folder(const std::filesystem::path& out) { return out / "log"; }

}  // namespace prehend
