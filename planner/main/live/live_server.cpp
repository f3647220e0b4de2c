#include "planner/main/live/live_server.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <future>
#include <iostream>
#include <poll.h>
#include <spawn.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "planner/live/protocol/graspit_endpoint.h"
#include "planner/live/protocol/graspit_text.h"
#include "planner/live/protocol/mcp_client.h"
#include "planner/live/protocol/recording_file.h"
#include "planner/live/protocol/request.h"
#include "planner/live/protocol/session_endpoint.h"
#include "planner/live/serve/few_heaps.h"
#include "planner/live/serve/line_splitter.h"
#include "planner/live/serve/server.h"
#include "planner/live/serve/token.h"
#include "planner/live/studio/studio_page.h"
#include "planner/main/live/live_options.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

// How soon an interrupt is noticed.
constexpr std::chrono::milliseconds kLook{50};

constexpr int kRecordingFailed = 1;  // exit status

// Where the lines of the session go. That a recording has ended is told here once, besides to the
// clients.
class Recorder {
 public:
  explicit Recorder(const std::filesystem::path& file) {
    if (!file.empty()) file_.emplace(file);
  }

  RecordLine taker() {
    if (!file_) return {};
    return [this](const std::string& line) { add(line); };
  }
  bool has_failed() const { return has_failed_; }

 private:
  void add(const std::string& line) {
    try {
      file_->add(line);
    } catch (const std::system_error& error) {
      if (!has_failed_.exchange(true)) std::cerr << "prehend: " << error.what() << "\n";
      throw;
    }
  }

  std::optional<RecordingFile> file_;
  std::atomic<bool> has_failed_ = false;  // set by the thread of commands
};

// Of a scene that is a file, its absolute path; names of the library stay as they are.
std::string scene_name(const std::string& scene) {
  return std::filesystem::exists(scene) ? std::filesystem::absolute(scene).string() : scene;
}

SessionOptions options_of(const LiveServer& live) {
  SessionLimits limits = live.session.limits;
  if (std::filesystem::exists(live.scene)) {
    limits.folders.push_back(std::filesystem::absolute(live.scene).parent_path());
  }
  return session_options(limits);
}

// Carries out a request as a client of its own, so that it is recorded with all others.
void request(SessionEndpoint& endpoint, const nlohmann::json& message) {
  std::promise<std::string> reply;
  bool came = false;
  const ClientId client = endpoint.connect([&](const std::string& text) {
    if (came || nlohmann::json::parse(text).contains("event")) return;
    reply.set_value(text);
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
                             .is_request = is_request,
                             .needs_token = !is_loopback(live.session.address)});
  }
  if (live.graspit) {
    options.lines.push_back({.endpoint = &graspit,
                             .port = *live.graspit,
                             .is_request = is_graspit_command,
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

// Waits for input of the file until `interrupts` end that; false then.
bool has_input(int file, const Interrupts& interrupts) {
  while (!interrupts.cancellation().requested()) {
    pollfd waits{file, POLLIN, 0};
    const int ready = ::poll(&waits, 1, static_cast<int>(kLook.count()));
    if (ready > 0) return true;
    if (ready < 0 && errno != EINTR) return false;
  }
  return false;
}

void load_first(const LiveServer& live, SessionEndpoint& endpoint) {
  if (live.scene.empty()) return;
  request(endpoint,
          {{"command", "scene.load"}, {"scene", scene_name(live.scene)}, {"fresh", true}});
}

}  // namespace

int run_mcp_server(const LiveServer& live, Interrupts& interrupts) {
  interrupts.cancel_first();
  use_few_heaps();
  Recorder recorder(live.session.record);
  SessionEndpoint endpoint(options_of(live), recorder.taker());
  load_first(live, endpoint);
  McpClient client(endpoint, PREHEND_VERSION, [](const std::string& line) {
    std::cout << line << "\n" << std::flush;
  });
  LineSplitter lines(kLongestMessage);
  std::vector<char> piece(1U << 16U);
  while (has_input(STDIN_FILENO, interrupts)) {
    const ssize_t size = ::read(STDIN_FILENO, piece.data(), piece.size());
    if (size <= 0) break;
    lines.add({piece.data(), static_cast<std::size_t>(size)},
              [&](const std::string& line, bool whole) {
                // What is too long is no JSON either, so that it is answered in its turn.
                client.receive(whole ? line : "");
                return true;
              });
  }
  const bool was_interrupted = interrupts.cancellation().requested();
  if (!was_interrupted) client.finish();
  if (recorder.has_failed()) return kRecordingFailed;
  return was_interrupted ? interrupts.exit_status() : 0;
}

int run_live_server(const LiveServer& live, Interrupts& interrupts) {
  interrupts.cancel_first();
  use_few_heaps();
  Recorder recorder(live.session.record);
  SessionEndpoint endpoint(options_of(live), recorder.taker());
  load_first(live, endpoint);
  GraspitEndpoint graspit(endpoint);
  Server server(server_options(live, endpoint, graspit));
  const ServerPorts ports = server.start();
  warn_of_strangers(live);
  say_where(live, ports, server);
  std::cerr << "Ctrl-C ends it\n";
  while (!interrupts.cancellation().requested()) std::this_thread::sleep_for(kLook);
  server.stop();
  // Whoever relies on the recording has to hear of it, however the session was ended.
  return recorder.has_failed() ? kRecordingFailed : interrupts.exit_status();
}

}  // namespace prehend
