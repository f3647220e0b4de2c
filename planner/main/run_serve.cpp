#include "planner/main/commands.h"

namespace prehend {

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

}  // namespace prehend
