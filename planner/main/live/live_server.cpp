#include "planner/main/live/live_server.h"

#include <chrono>
#include <fstream>
#include <future>
#include <iostream>
#include <spawn.h>
#include <thread>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "planner/live/protocol/graspit_endpoint.h"
#include "planner/live/protocol/graspit_text.h"
#include "planner/live/protocol/session_endpoint.h"
#include "planner/live/serve/server.h"
#include "planner/live/serve/token.h"
#include "planner/live/studio/studio_page.h"
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

// Of a scene that is a file, its absolute path; names of the library stay as they are.
std::string scene_name(const std::string& scene) {
  return std::filesystem::exists(scene) ? std::filesystem::absolute(scene).string() : scene;
}

OpenFolders open_folders(const LiveServer& live) {
  std::vector<std::filesystem::path> folders = live.session.folders;
  if (std::filesystem::exists(live.scene)) {
    folders.push_back(std::filesystem::absolute(live.scene).parent_path());
  }
  return OpenFolders(folders);
}

// Carries out a request as a client of its own, so that it is recorded with all others.
void request(SessionEndpoint& endpoint, const nlohmann::json& message) {
  std::promise<std::string> reply;
  bool came = false;
  const ClientId client = endpoint.connect([&](const std::string& text) {
    if (!came) reply.set_value(text);  // events follow
    came = true;
  });
  endpoint.receive(client, message.dump());
  const nlohmann::json answer = nlohmann::json::parse(reply.get_future().get());
  endpoint.disconnect(client);
  if (answer["ok"] == true) return;
  const nlohmann::json& error = answer["error"];
  throw InputError({.field = error.value("field", ""),
                    .problem = error.value("problem", ""),
                    .value = error.value("value", "")});
}

bool is_loopback(const std::string& address) {
  return address == "::1" || address.starts_with("127.");
}

ServerOptions server_options(const LiveServer& live, Endpoint& endpoint, Endpoint& graspit) {
  ServerOptions options;
  options.address = live.session.address;
  options.token = random_token();
  if (live.tcp) {
    options.lines.push_back({.endpoint = &endpoint,
                             .port = *live.tcp,
                             .needs_token = !is_loopback(live.session.address)});
  }
  if (live.graspit) {
    options.lines.push_back({.endpoint = &graspit,
                             .port = *live.graspit,
                             .refusal = graspit_error_line,
                             .needs_token = !is_loopback(live.session.address)});
  }
  if (!live.page) return options;
  StudioPage page = studio_page(random_token());
  options.http = HttpListener{
      .endpoint = &endpoint,
      .port = *live.page,
      .pages = {{"/", {.content_type = "text/html; charset=utf-8", .body = std::move(page.html)}}},
      .content_security_policy = std::move(page.content_security_policy)};
  return options;
}

void warn_of_strangers(const LiveServer& live) {
  if (is_loopback(live.session.address)) return;
  const bool in_colour = ::isatty(STDERR_FILENO) != 0;
  std::cerr << (in_colour ? "\033[1;31m" : "")
            << "Other machines can reach this session; who has the token can change it and the "
               "files of its folders."
            << (in_colour ? "\033[0m" : "") << "\n";
}

// As an address of the web has it.
std::string host_of(const std::string& address) {
  return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

// The program of the desktop that opens addresses. It is not waited for: some end with the browser.
void open_in_browser(const std::string& url) {
  std::string program = "xdg-open";
  std::string argument = url;
  char* words[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  if (::posix_spawnp(&child, program.c_str(), nullptr, nullptr, words, environ) != 0) {
    std::cerr << "there is no xdg-open to open the page with\n";
  }
}

void say_where(const LiveServer& live, const ServerPorts& ports, const Server& server) {
  if (live.tcp) {
    std::cout << "serving " << live.session.address << " port " << ports.lines.front()
              << ": one JSON text a line\n";
  }
  if (live.graspit) {
    std::cout << "serving " << live.session.address << " port " << ports.lines.back()
              << ": GraspIt!'s text protocol\n";
  }
  if (!ports.lines.empty() && !is_loopback(live.session.address)) {
    std::cout << "token " << server.token() << "\n";
  }
  if (live.page) {
    const std::string url = "http://" + host_of(live.session.address) + ":" +
                            std::to_string(ports.http) + "/?token=" + server.token();
    std::cout << "studio " << url << "\n";
    if (live.open) open_in_browser(url);
  }
  std::cout << std::flush;
}

}  // namespace

int run_live_server(const LiveServer& live, Interrupts& interrupts) {
  interrupts.cancel_first();
  std::optional<std::ofstream> recording = opened_recording(live.session.record);
  RecordLine record;
  if (recording) {
    record = [&recording](const std::string& line) { *recording << line << "\n" << std::flush; };
  }
  SessionEndpoint endpoint({open_folders(live), live.session.threads}, record);
  if (!live.scene.empty()) {
    request(endpoint,
            {{"command", "scene.load"}, {"scene", scene_name(live.scene)}, {"fresh", true}});
  }
  GraspitEndpoint graspit(endpoint);
  Server server(server_options(live, endpoint, graspit));
  const ServerPorts ports = server.start();
  warn_of_strangers(live);
  say_where(live, ports, server);
  std::cerr << "Ctrl-C ends it\n";
  while (!interrupts.cancellation().requested()) std::this_thread::sleep_for(kLook);
  server.stop();
  return interrupts.exit_status();
}

}  // namespace prehend
