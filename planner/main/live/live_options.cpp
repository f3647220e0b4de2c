#include "planner/main/live/live_options.h"

namespace prehend {

void add_live(CLI::App& command, LiveOptions& live) {
  command.add_option("--listen", live.address, "address of this machine to listen on")
      ->capture_default_str();
  command.add_option("--record", live.record, "file to write the session to, for replay");
  add_session(command, live.folders, live.threads);
}

void add_session(CLI::App& command, std::vector<std::filesystem::path>& folders, int& threads) {
  command.add_option("--folder", folders,
                     "whose files the commands may read and write; may be repeated");
  command.add_option("--threads", threads, "threads of plans, 0: all processors")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

}  // namespace prehend
