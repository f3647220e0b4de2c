// Options that the commands of prehend-live share.
#pragma once

#include <filesystem>
#include <vector>

#include <CLI/CLI.hpp>

#include "planner/main/live/live_server.h"

namespace prehend {

// --listen, --record, --folder, --threads.
void add_live(CLI::App& command, LiveOptions& live);

// --folder, --threads.
void add_session(CLI::App& command, std::vector<std::filesystem::path>& folders, int& threads);

}  // namespace prehend
