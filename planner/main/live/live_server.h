// One live session, served to clients until an interrupt.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "planner/main/interrupts.h"

namespace prehend {

// What a session may have.
struct SessionLimits {
  std::vector<std::filesystem::path> folders = {};  // whose files commands may name
  int threads = 0;                                  // of plans; 0: all processors
  std::uint64_t undo_memory = 512;  // SessionOptions::undo_memory [MB of 2^20 bytes]
};

// What all commands that serve a session have.
struct LiveOptions {
  std::string address = "127.0.0.1";  // of this machine, to listen on
  std::filesystem::path record = {};  // empty: nothing is recorded
  SessionLimits limits = {};
};

struct LiveServer {
  LiveOptions session = {};
  std::optional<std::uint16_t> page = {};     // port of the studio; 0: any free one
  std::optional<std::uint16_t> tcp = {};      // port of JSON lines; 0: any free one
  std::optional<std::uint16_t> graspit = {};  // port of GraspIt!'s text protocol; 0: any free one
  std::string scene = {};                     // to begin with; empty: a hand alone
  bool open = false;                          // the page in the browser of the desktop
};

// Prints where it listens, one line each, and returns the exit status. The folder of a scene that
// is a file is open as well. Throws InputError for what cannot be opened, and for a scene that
// cannot be read.
int run_live_server(const LiveServer& live, Interrupts& interrupts);

// The session for one assistant, which speaks on the standard input and output (McpClient). Ends
// with the input, once all is answered, and returns the exit status. Throws InputError as above.
int run_mcp_server(const LiveServer& live, Interrupts& interrupts);

}  // namespace prehend
