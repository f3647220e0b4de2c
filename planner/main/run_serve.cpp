#include <chrono>
#include <fstream>
#include <iostream>
#include <optional>
#include <thread>

#include "planner/main/commands.h"
#include "planner/protocol/session_endpoint.h"
#include "planner/serve/server.h"
#include "sim/base/input_error.h"
#include "sim/base/output_file.h"

namespace prehend {
namespace {

// How soon an interrupt is noticed.
constexpr std::chrono::milliseconds kLook{50};

// Where the lines of the session go; they are on disk as soon as they are there, since a session
// may end by a power cut.
std::optional<std::ofstream> opened_recording(const std::filesystem::path& file) {
  if (file.empty()) return std::nullopt;
  require_writable(std::filesystem::absolute(file).parent_path());
  std::ofstream stream(file, std::ios::binary);
  if (!stream) {
    throw InputError({.field = "--record", .problem = "cannot be written", .value = file.string()});
  }
  return stream;
}

}  // namespace

int run_serve(const ServeCommand& command, Interrupts& interrupts) {
  interrupts.cancel_first();
  std::optional<std::ofstream> recording = opened_recording(command.record);
  RecordLine record;
  if (recording) {
    record = [&recording](const std::string& line) { *recording << line << "\n" << std::flush; };
  }
  SessionEndpoint endpoint({OpenFolders(command.folders), command.threads}, record);
  ServerOptions options;
  options.lines.push_back({.endpoint = &endpoint, .port = command.tcp});
  Server server(options);
  const ServerPorts ports = server.start();
  std::cout << "serving " << options.address << " port " << ports.lines.front()
            << ": one JSON text a line\n"
            << std::flush;
  std::cerr << "Ctrl-C ends it\n";
  while (!interrupts.cancellation().requested()) std::this_thread::sleep_for(kLook);
  server.stop();
  return interrupts.exit_status();
}

}  // namespace prehend
