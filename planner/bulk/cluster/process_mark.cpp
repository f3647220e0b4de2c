#include "planner/bulk/cluster/process_mark.h"

#include <fstream>
#include <sstream>
#include <unistd.h>

#include "sim/base/host_name.h"

namespace prehend {
namespace {

std::string first_word(const char* file) {
  std::ifstream stream(file);
  std::string word;
  stream >> word;
  return word;
}

// Field 22 of /proc/PID/stat (proc(5)), counted from behind the name, which may have any
// characters. Nothing for processes that are gone, or dead and not yet waited for.
std::optional<std::uint64_t> start_of(pid_t pid) {
  std::ostringstream text;
  text << std::ifstream("/proc/" + std::to_string(pid) + "/stat").rdbuf();
  const std::string all = text.str();
  const std::size_t name_end = all.rfind(')');
  if (name_end == std::string::npos) return std::nullopt;
  std::istringstream fields(all.substr(name_end + 1));
  std::string state;
  fields >> state;
  if (state == "Z" || state == "X") return std::nullopt;
  std::string skipped;
  for (int field = 4; field < 22; ++field) fields >> skipped;
  std::uint64_t started = 0;
  if (!(fields >> started)) return std::nullopt;
  return started;
}

}  // namespace

std::optional<ProcessMark> mark_of(pid_t pid) {
  const std::optional<std::uint64_t> started = start_of(pid);
  if (!started) return std::nullopt;
  return ProcessMark{.host = host_name(),
                     .boot = first_word("/proc/sys/kernel/random/boot_id"),
                     .pid = pid,
                     .started = *started};
}

ProcessState state_of(const ProcessMark& mark) {
  if (mark.host != host_name()) return ProcessState::elsewhere;
  const std::optional<ProcessMark> now = mark_of(mark.pid);
  const bool same = now && now->boot == mark.boot && now->started == mark.started;
  return same ? ProcessState::running : ProcessState::gone;
}

}  // namespace prehend
