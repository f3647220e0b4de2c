#include "planner/bulk/cluster/slurm_queue.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "planner/bulk/cluster/run_words.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

std::string with_commas(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ",") + word;
  return text;
}

}  // namespace

bool is_queued_state(const std::string& state) {
  constexpr std::array<std::string_view, 12> kStates{
      "PENDING",  "RUNNING",      "COMPLETING",  "CONFIGURING", "SUSPENDED", "REQUEUED",
      "RESIZING", "REQUEUE_HOLD", "REQUEUE_FED", "SIGNALING",   "STAGE_OUT", "STOPPED"};
  return std::find(kStates.begin(), kStates.end(), state) != kStates.end();
}

std::vector<QueuedTask> parse_queue(const std::string& printed) {
  std::vector<QueuedTask> tasks;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    QueuedTask task;
    if (words >> task.job >> task.task >> task.state >> task.restarts) tasks.push_back(task);
  }
  return tasks;
}

std::vector<QueuedTask> queued_tasks(const std::vector<std::string>& ids) {
  const std::vector<std::string> words{
      "squeue",
      "--noheader",
      "--array",
      "--states=all",
      "--jobs=" + with_commas(ids),
      "--Format=ArrayJobID:24 ,ArrayTaskID:24 ,State:24 ,RestartCnt:12 "};
  const Finished finished = run_words(words);
  if (finished.status == 0) return parse_queue(finished.out);
  // Of jobs that ended a while ago Slurm knows nothing any more.
  if (finished.err.find("Invalid job id") != std::string::npos) return {};
  throw InputError({.field = "squeue", .problem = finished.err.substr(0, finished.err.find('\n'))});
}

std::map<std::string, int> parse_accounting(const std::string& printed) {
  std::map<std::string, int> counts;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    const std::string state = line.substr(0, line.find_first_of(" |"));  // "CANCELLED by 1000"
    if (!state.empty() && !is_queued_state(state)) ++counts[state];
  }
  return counts;
}

std::optional<std::map<std::string, int>> ended_tasks(const std::string& id) {
  const Finished finished = run_words(
      {"sacct", "--noheader", "--allocations", "--parsable2", "--jobs=" + id, "--format=State"});
  if (finished.status != 0) return std::nullopt;
  return parse_accounting(finished.out);
}

}  // namespace prehend
