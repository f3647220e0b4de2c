#include <iostream>

#include "planner/main/commands.h"
#include "planner/protocol/recording.h"
#include "sim/base/input_file.h"
#include "sim/base/output_file.h"

namespace prehend {

int run_replay(const ReplayCommand& command, Interrupts& interrupts) {
  const std::filesystem::path folder = std::filesystem::absolute(command.out).parent_path();
  require_writable(folder);
  const SessionOptions options{OpenFolders(command.folders), command.threads};
  const std::string recording = read_file(command.file);
  interrupts.cancel_first();
  Replayed replayed;
  try {
    RunContext context;
    context.cancellation = interrupts.cancellation();
    replayed = replay(recording, command.file.string(), options, context);
  } catch (const Cancelled&) {
    std::cerr << "prehend: " << interrupts.reason() << ", nothing is written\n";
    return interrupts.exit_status();
  }
  interrupts.end_at_once("nothing is written");
  make_folder(folder);
  interrupts.write(command.out, replay_text(replayed));
  std::cout << replayed.replies.size() << " commands, " << replayed.refused << " refused\nwrote "
            << command.out.string() << "\n";
  return 0;
}

}  // namespace prehend
