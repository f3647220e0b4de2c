// The commands of prehend-live: one session, served to clients, or replayed.
#pragma once

#include "planner/main/command_line.h"

namespace prehend {

// Each declares a command below `app`, which sets request.run once it is read.
void add_mcp(CLI::App& app, CommandRequest& request);
void add_replay(CLI::App& app, CommandRequest& request);
void add_serve(CLI::App& app, CommandRequest& request);
void add_studio(CLI::App& app, CommandRequest& request);

}  // namespace prehend
