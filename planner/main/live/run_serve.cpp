#include "planner/main/live/live_commands.h"
#include "planner/main/live/live_options.h"
#include "planner/main/other_programs.h"
#include "planner/main/shared_options.h"

namespace prehend {
namespace {

// Arguments of `serve`.
struct ServeCommand {
  std::uint16_t tcp = 4700;                   // port; 0: any free one
  std::optional<std::uint16_t> graspit = {};  // port of GraspIt!'s text protocol; 0: any free one
  std::string scene = {};                     // to begin with; empty: a hand alone
  LiveOptions session;
};

void declare(CLI::App& command, ServeCommand& options) {
  add_examples(command, {"serve --scene mug", "serve --tcp 0 --graspit"});
  command
      .add_option("--tcp", options.tcp,
                  "port for JSON lines (docs/reference/protocol.md), 0: a free one")
      ->capture_default_str();
  command
      .add_option("--graspit", options.graspit,
                  "port for GraspIt!'s text protocol (docs/reference/graspit-protocol.md); 4765")
      ->expected(0, 1)
      ->default_str("4765");
  command.add_option("--scene", options.scene,
                     "scene name, scene file or mesh file to begin with; a hand alone");
  add_live(command, options.session);
}

// Arguments of `mcp`.
struct McpCommand {
  std::string scene = {};  // to begin with; empty: a hand alone
  std::filesystem::path record = {};
  SessionLimits limits = {};
};

void declare(CLI::App& command, McpCommand& options) {
  add_examples(command, {"mcp", "mcp --scene mug --folder meshes"});
  command.add_option("--scene", options.scene,
                     "scene name, scene file or mesh file to begin with; a hand alone");
  command.add_option("--record", options.record, "file to write the session to, for replay");
  add_session(command, options.limits);
}

// Arguments of `studio`.
struct StudioCommand {
  std::string scene = "mug";         // scene name, scene file or mesh file
  bool empty = false;                // without it
  std::uint16_t port = 4701;         // of the page; 0: any free one
  std::optional<std::uint16_t> tcp;  // of JSON lines beside it
  bool open = false;                 // in the browser of the desktop
  LiveOptions session;
};

void declare(CLI::App& command, StudioCommand& options) {
  add_examples(command, {"studio mug --open", "studio --empty --port 8080"});
  command.add_option("scene", options.scene, "scene name, scene file or mesh file to begin with")
      ->capture_default_str();
  command.add_flag("--empty", options.empty, "begin with a hand alone");
  command.add_option("--port", options.port, "port of the page, 0: a free one")
      ->capture_default_str();
  command.add_option("--tcp", options.tcp, "port for JSON lines of other programs beside it");
  command.add_flag("--open", options.open, "open the page in the browser");
  add_live(command, options.session);
}

int run_serve(const ServeCommand& command, Interrupts& interrupts) {
  LiveServer live{.session = command.session};
  live.tcp = command.tcp;
  live.graspit = command.graspit;
  live.scene = command.scene;
  return run_live_server(live, interrupts);
}

int run_studio(const StudioCommand& command, Interrupts& interrupts) {
  LiveServer live{.session = command.session};
  live.page = command.port;
  live.tcp = command.tcp;
  live.scene = command.empty ? std::string() : command.scene;
  live.open = command.open;
  return run_live_server(live, interrupts);
}

int run_mcp(const McpCommand& command, Interrupts& interrupts) {
  LiveServer live;
  live.session.record = command.record;
  live.session.limits = command.limits;
  live.scene = command.scene;
  return run_mcp_server(live, interrupts);
}

}  // namespace

void add_mcp(CLI::App& app, CommandRequest& request) {
  add_command(app, request, kMcp.name, kMcp.summary, declare, run_mcp);
}

void add_serve(CLI::App& app, CommandRequest& request) {
  add_command(app, request, kServe.name, kServe.summary, declare, run_serve);
}

void add_studio(CLI::App& app, CommandRequest& request) {
  add_command(app, request, kStudio.name, kStudio.summary, declare, run_studio);
}

}  // namespace prehend
