#include "planner/main/live/live_options.h"

namespace prehend {

void add_live(CLI::App& command, LiveOptions& live) {
  command.add_option("--listen", live.address, "address of this machine to listen on")
      ->capture_default_str();
  command.add_option("--record", live.record, "file to write the session to, for replay");
  add_session(command, live.limits);
}

SessionOptions session_options(const SessionLimits& session) {
  return {OpenFolders(session.folders), session.threads,
          static_cast<std::size_t>(session.undo_memory) << 20U};
}

void add_session(CLI::App& command, SessionLimits& session) {
  command.add_option("--folder", session.folders,
                     "whose files the commands may read and write; may be repeated");
  command.add_option("--threads", session.threads, "threads of plans, 0: all processors")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  command.add_option("--undo-memory", session.undo_memory, "MB of earlier states that undo keeps")
      ->check(CLI::Range(std::uint64_t{0}, std::uint64_t{1} << 24))
      ->capture_default_str();
}

}  // namespace prehend
