#include <iostream>

#include "planner/live/protocol/recording.h"
#include "planner/live/protocol/session_film.h"
#include "planner/main/live/live_commands.h"
#include "planner/main/live/live_options.h"
#include "planner/main/other_programs.h"
#include "planner/main/shared_options.h"
#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

// Arguments of `replay`.
struct ReplayCommand {
  std::filesystem::path file;
  std::filesystem::path out = "out/replay.json";
  std::filesystem::path gltf;  // an animation to write; empty: none
  SessionLimits session;
};

void declare(CLI::App& command, ReplayCommand& options) {
  add_examples(command, {"replay session.jsonl", "replay session.jsonl --gltf session.glb"});
  command
      .add_option("file", options.file,
                  "recording, one command a line (docs/reference/protocol.md)")
      ->required();
  command.add_option("--out", options.out, "file to write what comes of it to")
      ->capture_default_str();
  command.add_option("--gltf", options.gltf,
                     "write the session as an animation to this file (.glb)");
  add_session(command, options.session);
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).parent_path();
}

int run_replay(const ReplayCommand& command, Interrupts& interrupts) {
  const bool filmed = !command.gltf.empty();
  require(!filmed || command.gltf.extension() == ".glb",
          {.field = "--gltf", .problem = "must end in .glb", .value = command.gltf.string()});
  require_writable(folder_of(command.out));
  if (filmed) require_writable(folder_of(command.gltf));
  const SessionOptions options = session_options(command.session);
  const std::string recording = read_file(command.file);
  interrupts.cancel_first();
  Replayed replayed;
  SceneFilm film;
  WatchSession watch;
  if (filmed) watch = [&film](const Session& session) { add_moment(film, session); };
  try {
    RunContext context;
    context.cancellation = interrupts.cancellation();
    replayed = replay(recording, command.file.string(), options, context, watch);
  } catch (const Cancelled&) {
    std::cerr << "prehend: " << interrupts.reason() << ", nothing is written\n";
    return interrupts.exit_status();
  }
  interrupts.end_at_once("nothing is written");
  make_folder(folder_of(command.out));
  interrupts.write(command.out, replay_text(replayed));
  std::cout << replayed.replies.size() << " commands, " << replayed.refused << " refused\nwrote "
            << command.out.string() << "\n";
  if (!filmed) return 0;
  make_folder(folder_of(command.gltf));
  interrupts.write(command.gltf, session_glb(film));
  std::cout << "wrote " << command.gltf.string() << "\n";
  return 0;
}

}  // namespace

void add_replay(CLI::App& app, CommandRequest& request) {
  add_command(app, request, kReplay.name, kReplay.summary, declare, run_replay);
}

}  // namespace prehend
