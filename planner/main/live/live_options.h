// Options that the commands of prehend-live share.
#pragma once

#include <CLI/CLI.hpp>

#include "planner/live/session.h"
#include "planner/main/live/live_server.h"

namespace prehend {

// --listen, --record, and those of add_session.
void add_live(CLI::App& command, LiveOptions& live);

// Throws InputError for a folder that is not there.
SessionOptions session_options(const SessionLimits& session);

// --folder, --threads, --undo-memory.
void add_session(CLI::App& command, SessionLimits& session);

}  // namespace prehend
