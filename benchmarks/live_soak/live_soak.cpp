#include "benchmarks/live_soak/live_soak.h"

#include <algorithm>
#include <barrier>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <cmath>
#include <fstream>
#include <malloc.h>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <unistd.h>

#include "benchmarks/live_soak/judge_reply.h"
#include "benchmarks/live_soak/judge_session.h"
#include "benchmarks/live_soak/random_request.h"
#include "planner/live/protocol/request.h"
#include "planner/live/protocol/session_endpoint.h"
#include "planner/live/serve/server.h"

namespace prehend::live_soak {
namespace {

using Clock = std::chrono::steady_clock;

// Requests of each client between two pauses.
constexpr int kBetweenPauses = 40;
// How often the memory is measured: what a heap keeps hangs on what was in it just before.
constexpr std::size_t kMeasuredAQuarter = 10;
// Least pauses between two measurements: each begins the session anew.
constexpr int kPausesBetween = 5;
// Of the events that come to a client, so many are one that it looks at.
constexpr std::size_t kLookAtEvery = 5;

double resident_megabytes() {
  ::malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double size = 0.0;
  double resident = 0.0;
  file >> size >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

// What all clients have found, for several threads.
class Findings {
 public:
  void fault(const std::string& words, const std::string& request) {
    const std::lock_guard hold(lock_);
    LiveSoakResult::Fault& fault = result_.faults[words];
    if (fault.count++ == 0) fault.first = request.substr(0, 20000);
  }
  template <typename Add>
  void count(const Add& add) {
    const std::lock_guard hold(lock_);
    add(result_);
  }
  LiveSoakResult result() const {
    const std::lock_guard hold(lock_);
    return result_;
  }

 private:
  mutable std::mutex lock_;
  LiveSoakResult result_;
};

class SoakClient {
 public:
  SoakClient(std::uint16_t port, Findings& findings)
      : stream_(boost::asio::ip::tcp::endpoint(boost::asio::ip::address_v4::loopback(), port)),
        findings_(findings) {
    // A long request is written in parts: the second would wait for the answer to the first.
    stream_.socket().set_option(boost::asio::ip::tcp::no_delay(true));
  }

  // The reply, which was judged.
  Json reply_to(Json request) {
    request["id"] = ++last_id_;
    const std::string line = request.dump(-1, ' ', false, Json::error_handler_t::replace);
    Json reply = next_reply(line);
    const std::string fault = fault_of_reply(reply, last_id_);
    if (!fault.empty()) findings_.fault(fault, line);
    if (reply.contains("error") && request["command"].is_string()) {
      const std::string problem = reply["error"].value("problem", "");
      const std::string words =
          request["command"].get<std::string>() + ": " + problem.substr(0, 60);
      findings_.count([&](LiveSoakResult& result) { ++result.refusals[words]; });
    }
    return reply;
  }
  Json result_of(const Json& request) {
    const Json reply = reply_to(request);
    return reply.value("result", Json::object());
  }
  Json state() { return last_state_ = result_of({{"command", "state"}}); }
  // That was heard last.
  const Json& last_state() const { return last_state_; }

  void send_nonsense(const std::string& line) {
    const Json reply = next_reply(line);
    if (reply.value("ok", true)) findings_.fault("nonsense was carried out", line);
  }

 private:
  Json next_reply(const std::string& request) {
    stream_ << request << '\n' << std::flush;
    while (true) {
      std::string line;
      if (!std::getline(stream_, line)) {
        findings_.fault("the client was disconnected", request);
        throw std::runtime_error("disconnected");
      }
      // Most events are as many others: they need not be looked at by all clients.
      const bool is_event = line.starts_with(R"({"event")");
      if (is_event && ++events_ % kLookAtEvery != 0) continue;
      Json message = Json::parse(line, nullptr, false);
      if (message.is_discarded()) {
        findings_.fault("no JSON came", request);
      } else if (message.contains("event")) {
        const std::string fault = fault_of_event(message);
        if (!fault.empty()) findings_.fault(fault, line);
        if (message["event"] == "state") last_state_ = std::move(message["state"]);
      } else {
        const bool well = message.value("ok", false);
        findings_.count(
            [&](LiveSoakResult& result) { ++(well ? result.carried_out : result.refused); });
        return message;
      }
    }
  }

  boost::asio::ip::tcp::iostream stream_;
  Findings& findings_;
  int last_id_ = 0;
  std::size_t events_ = 0;
  Json last_state_;
};

// What is looked at while nobody else talks.
class Judge {
 public:
  Judge(std::uint16_t port, const KnownNames& names, std::uint64_t seed, Findings& findings)
      : one_(port, findings),
        other_(port, findings),
        names_(names),
        random_(seed),
        findings_(findings) {}

  void judge() {
    rest();
    repair();
    judge_epsilon();
    for (int i = 0; i < 3; ++i) judge_undo();
  }
  // Until nothing runs: what is running would refuse changes, and make some of its own.
  void rest() {
    one_.reply_to({{"command", "plan.cancel"}});
    one_.reply_to({{"command", "path.cancel"}});
    one_.reply_to({{"command", "time.stop"}});
    for (Json state = one_.state();
         state.value("planning", false) || state.value("finding_path", false);
         state = one_.state()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }

  Json state() { return one_.state(); }

  // The same session each time, so that its memory can be compared: one scene and no history.
  void begin_anew() {
    rest();
    const Json state = one_.state();
    for (const Json& pin : state["pins"])
      one_.reply_to({{"command", "pin.remove"}, {"name", pin["name"]}});
    one_.reply_to({{"command", "scene.load"}, {"scene", "mug"}, {"fresh", true}});
  }

 private:
  // Random edits often leave a scene in which no hand can close on anything.
  void repair() {
    const Json state = one_.state();
    if (state["object"].is_object() && state["problem"].is_null() && random_.index(4) != 0) return;
    const bool is_library = random_.index(3) == 0;
    if (is_library) {
      one_.reply_to({{"command", "scene.load"},
                     {"scene", names_.scenes[random_.index(names_.scenes.size())]}});
    } else {
      const std::string hand = names_.hands[random_.index(names_.hands.size())];
      one_.reply_to({{"command", "scene.new"}, {"hand", hand}});
      const char* objects[] = {"ball", "box", "cylinder"};
      one_.reply_to(
          {{"command", "object.set"}, {"generate", objects[random_.index(3)]}, {"triangles", 300}});
      one_.reply_to({{"command", "hand.approach"}});
      one_.reply_to({{"command", "hand.back_off"}, {"distance", 0.003}});
    }
  }

  void judge_undo() {
    names_.state = one_.state();
    const Json change = random_change(random_, names_);
    const JudgedChange judged =
        judge_change(ask(one_), ask(other_), [&] { return one_.reply_to(change); });
    if (!judged.fault.empty()) {
      findings_.fault(judged.fault + ": " + change["command"].get<std::string>(), change.dump());
    }
    findings_.count([&](LiveSoakResult& result) {
      result.unchanged += judged.end == ChangeEnd::refused ? 1 : 0;
      result.undone += judged.end == ChangeEnd::one_step ? 1 : 0;
    });
  }

  void judge_epsilon() {
    const JudgedGrasp judged = judge_grasp(ask(one_));
    if (!judged.fault.empty()) findings_.fault(judged.fault, judged.detail);
    findings_.count([&](LiveSoakResult& result) {
      result.evaluated += judged.is_evaluated ? 1 : 0;
      result.stable += judged.is_stable ? 1 : 0;
      result.at_edges += judged.is_at_an_edge ? 1 : 0;
    });
  }

  static Ask ask(SoakClient& client) {
    return [&client](const Json& request) { return client.reply_to(request); };
  }

  SoakClient one_;
  SoakClient other_;
  KnownNames names_;
  Random random_;
  Findings& findings_;
};

// All that goes on, from the start of the server to its end.
class LiveSoak {
 public:
  explicit LiveSoak(const LiveSoakOptions& options)
      : options_(options),
        endpoint_(SessionOptions{.threads = 2, .undo_memory = options.undo_memory},
                  options.replays
                      ? RecordLine([this](const std::string& line) { recording_ += line + "\n"; })
                      : RecordLine()),
        server_([this] {
          ServerOptions server;
          server.lines.push_back({.endpoint = &endpoint_, .is_request = is_request});
          return server;
        }()),
        port_(server_.start().lines.at(0)) {}

  LiveSoakResult run() {
    // It leaves at once: what is told to a client that does not read is kept for it.
    names_ = names_of(SoakClient(port_, findings_).result_of({{"command", "hello"}}));
    judge_.emplace(port_, names_, options_.seed, findings_);
    // NOLINTNEXTLINE(bugprone-exception-escape): as meet()
    std::barrier pause(options_.clients, [this]() noexcept { meet(); });
    std::vector<std::thread> threads;
    for (int i = 0; i < options_.clients; ++i) {
      threads.emplace_back([this, i, &pause] {
        talk(options_.seed * 1000 + static_cast<std::uint64_t>(i) + 1, pause);
      });
    }
    for (std::thread& thread : threads) thread.join();
    if (options_.replays) judge_replay();
    return findings_.result();
  }

 private:
  template <typename Pause>
  void talk(std::uint64_t seed, Pause& pause) {
    try {
      Random random(seed);
      SoakClient client(port_, findings_);
      KnownNames names = names_;
      client.state();
      while (!is_over_) {
        for (int k = 0; k < kBetweenPauses; ++k) {
          names.state = client.last_state();
          if (random.index(25) == 0) {
            client.send_nonsense(random_nonsense(random, names));
          } else {
            client.reply_to(random_request(random, names));
          }
        }
        pause.arrive_and_wait();
      }
    } catch (const std::exception& error) {
      findings_.fault(std::string("a client has ended: ") + error.what(), "");
    }
    pause.arrive_and_drop();
  }

  // All clients wait. Whatever is thrown beyond the judge ends the program, as it should.
  // NOLINTNEXTLINE(bugprone-exception-escape)
  void meet() noexcept {
    try {
      judge_->judge();
    } catch (const std::exception& error) {
      findings_.fault(std::string("the judge has ended: ") + error.what(), "");
      is_over_ = true;
    }
    long done = 0;
    std::size_t measured = 0;
    findings_.count([&](const LiveSoakResult& result) {
      done = result.messages();
      measured = result.resident.size();
    });
    const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    const double share =
        std::max(static_cast<double>(done) / static_cast<double>(options_.messages),
                 elapsed / options_.seconds);
    const auto in_all = static_cast<double>(4 * kMeasuredAQuarter);
    if (++pauses_ >= kPausesBetween && measured < 4 * kMeasuredAQuarter &&
        share >= static_cast<double>(measured + 1) / in_all) {
      pauses_ = 0;
      judge_->begin_anew();
      findings_.count(
          [](LiveSoakResult& result) { result.resident.push_back(resident_megabytes()); });
    }
    if (share >= 1.0 || (options_.interrupted && options_.interrupted())) is_over_ = true;
    if (options_.progress) findings_.count(options_.progress);
  }

  void judge_replay() {
    judge_->rest();
    const Json state = judge_->state();
    server_.stop();
    const Replayed replayed = replay(
        recording_, "recording", SessionOptions{.threads = 1, .undo_memory = options_.undo_memory});
    if (Json::parse(replayed.state) != state) findings_.fault("the replay ends elsewhere", "");
  }

  LiveSoakOptions options_;
  Findings findings_;
  std::string recording_;
  SessionEndpoint endpoint_;
  Server server_;
  std::uint16_t port_ = 0;
  KnownNames names_;
  std::optional<Judge> judge_;
  int pauses_ = 0;  // since memory was measured
  std::atomic<bool> is_over_ = false;
  Clock::time_point start_ = Clock::now();
};

}  // namespace

std::vector<double> LiveSoakResult::quarters() const {
  std::vector<double> medians;
  for (std::size_t i = 0; i + kMeasuredAQuarter <= resident.size(); i += kMeasuredAQuarter) {
    const auto begin = resident.begin() + static_cast<std::ptrdiff_t>(i);
    std::vector<double> quarter(begin, begin + static_cast<std::ptrdiff_t>(kMeasuredAQuarter));
    std::sort(quarter.begin(), quarter.end());
    medians.push_back(quarter[kMeasuredAQuarter / 2]);
  }
  return medians;
}

double LiveSoakResult::growth() const {
  const std::vector<double> medians = quarters();
  if (medians.size() < 2) return 0.0;
  return *std::max_element(medians.begin() + 1, medians.end()) / medians.front() - 1.0;
}

LiveSoakResult run_live_soak(const LiveSoakOptions& options) { return LiveSoak(options).run(); }

}  // namespace prehend::live_soak
