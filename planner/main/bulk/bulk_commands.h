// The commands of prehend-bulk: what works through many objects or many grasps.
#pragma once

#include "planner/main/command_line.h"

namespace prehend {

// Each declares a command below `app`, which sets request.run once it is read.
void add_validate(CLI::App& app, CommandRequest& request);
void add_learn(CLI::App& app, CommandRequest& request);
void add_design(CLI::App& app, CommandRequest& request);
void add_batch(CLI::App& app, CommandRequest& request);
// submit, cancel and queue, below `batch`.
void add_cluster_commands(CLI::App& batch, CommandRequest& request);

}  // namespace prehend
