#include "planner/main/live/live_commands.h"
#include "planner/main/program.h"

namespace {

void add_commands(CLI::App& app, prehend::CommandRequest& request) {
  prehend::add_studio(app, request);
  prehend::add_serve(app, request);
  prehend::add_mcp(app, request);
  prehend::add_replay(app, request);
}

}  // namespace

int main(int argc, char** argv) { return prehend::run_program(argc, argv, add_commands); }
