#include "planner/main/commands.h"
#include "planner/main/live_server.h"

namespace prehend {

int run_serve(const ServeCommand& command, Interrupts& interrupts) {
  LiveServer live;
  live.address = command.session.address;
  live.tcp = command.tcp;
  live.graspit = command.graspit;
  live.scene = command.scene;
  live.record = command.session.record;
  live.folders = command.session.folders;
  live.threads = command.session.threads;
  return run_live_server(live, interrupts);
}

int run_studio(const StudioCommand& command, Interrupts& interrupts) {
  LiveServer live;
  live.address = command.session.address;
  live.page = command.port;
  live.tcp = command.tcp;
  live.scene = command.empty ? std::string() : command.scene;
  live.record = command.session.record;
  live.folders = command.session.folders;
  live.threads = command.session.threads;
  live.open = command.open;
  return run_live_server(live, interrupts);
}

}  // namespace prehend
