#include "planner/live/protocol/recording.h"

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>

#include "planner/live/protocol/session_json.h"
#include "sim/scene/scene_text.h"

namespace prehend {
namespace {

constexpr const char* kPlanFinished = "plan.finished";
constexpr const char* kPathFinished = "path.finished";

// A line that tells of something else than a request.
bool is_note(const JsonFile& line) {
  return line.root().is_object() && line.root().has("recorded");
}

// A recording on its way through a session.
class Replay {
 public:
  Replay(Session& session, const Cancellation& cancellation)
      : session_(session), cancellation_(cancellation) {}

  void follow(const std::string& line) {
    const Request request = read_request(line);
    if (request.json && is_note(*request.json)) return follow_note(request.json->root());
    if (!request.json) throw InputError(*request.error);
    const CommandScope scope{session_, [this] { return listener(); }, false};
    const std::string reply = reply_to(request, scope);
    bytes_ += reply.size();
    require(bytes_ <= kMostReplies,
            {.problem = "the replies are longer than " + std::to_string(kMostReplies) + " bytes"});
    if (!nlohmann::json::parse(reply)["ok"].get<bool>()) ++replayed.refused;
    replayed.replies.push_back(reply);
  }

  Replayed replayed;

 private:
  PlanListener listener() {
    // What is asked for while something runs is refused, and does not end.
    if (session_.is_planning() || session_.is_finding_path()) return {};
    ended_ = std::make_shared<std::promise<void>>();
    PlanListener listener;
    listener.ended = [ended = ended_] { ended->set_value(); };
    return listener;
  }

  // Until what runs has ended. Throws Cancelled, and ends it then.
  void wait(const Cancellation& running) {
    constexpr std::chrono::milliseconds kLook{20};
    const std::future<void> end = ended_->get_future();
    while (end.wait_for(kLook) != std::future_status::ready) {
      if (cancellation_.requested()) running.request();
    }
    cancellation_.check();
  }

  void follow_end_of_path(const JsonField& note) {
    note.allow_only({"recorded", "cancelled"});
    const std::optional<Cancellation> running = session_.path_cancellation();
    if (!running) note["recorded"].fail("no path is looked for");
    if (note.has("cancelled") && note["cancelled"].boolean()) {
      session_.give_up_path();
    } else {
      wait(*running);
      (void)session_.finish_path();
    }
  }

  void follow_note(const JsonField& note) {
    const std::string what = note["recorded"].text();
    if (what == kPathFinished) return follow_end_of_path(note);
    note.allow_only({"recorded", "results"});
    if (what != kPlanFinished) note["recorded"].fail("unknown");
    const std::optional<Cancellation> running = session_.plan_cancellation();
    if (!running) note["recorded"].fail("no plan is running");
    if (note.has("results")) {
      session_.keep_results(note["results"].text());
    } else {
      wait(*running);
      (void)session_.finish_plan();
    }
  }

  Session& session_;
  const Cancellation& cancellation_;
  std::size_t bytes_ = 0;  // of replies
  std::shared_ptr<std::promise<void>> ended_;
};

}  // namespace

std::string recorded_request(const Request& request) { return request.json->root().json(); }

std::string recorded_end_of_plan(const std::string& results) {
  ProtocolJson note{{"recorded", kPlanFinished}};
  if (!results.empty()) note["results"] = results;
  return message_text(note);
}

std::string recorded_end_of_path(PathEnd end) {
  ProtocolJson note{{"recorded", kPathFinished}};
  if (end == PathEnd::cancelled) note["cancelled"] = true;
  return message_text(note);
}

Replayed replay(const std::string& recording, const std::string& file, SessionOptions options,
                const RunContext& context, const WatchSession& watch) {
  Session session(std::move(options));
  Replay run(session, context.cancellation);
  if (watch) watch(session);
  std::istringstream lines(recording);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    context.cancellation.check();
    if (line.empty()) continue;
    const std::uint64_t before = session.revision();
    try {
      run.follow(line);
    } catch (const InputError& error) {
      throw InputError({file, "line " + std::to_string(number), error.what()});
    }
    if (watch && session.revision() != before) watch(session);
  }
  Replayed replayed = std::move(run.replayed);
  const EditedScene& world = *session.state().world;
  if (world.has_object()) replayed.scene = scene_text(world.scene());
  replayed.state = message_text(state_json(session));
  return replayed;
}

std::string replay_text(const Replayed& replayed) {
  ProtocolJson json{{"scene", replayed.scene}, {"state", ProtocolJson::parse(replayed.state)}};
  json["replies"] = ProtocolJson::array();
  for (const std::string& reply : replayed.replies) {
    json["replies"].push_back(ProtocolJson::parse(reply));
  }
  return json.dump(1, ' ', false, ProtocolJson::error_handler_t::replace) + "\n";
}

}  // namespace prehend
