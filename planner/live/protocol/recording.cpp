#include "planner/live/protocol/recording.h"

#include <cstdint>
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

void follow_end_of_path(const JsonField& note, Session& session) {
  note.allow_only({"recorded", "cancelled"});
  if (!session.is_finding_path()) note["recorded"].fail("no path is looked for");
  if (note.has("cancelled") && note["cancelled"].boolean()) {
    session.give_up_path();
  } else {
    (void)session.finish_path();
  }
}

void follow_note(const JsonField& note, Session& session) {
  const std::string what = note["recorded"].text();
  if (what == kPathFinished) {
    follow_end_of_path(note, session);
    return;
  }
  note.allow_only({"recorded", "results"});
  if (what != kPlanFinished) note["recorded"].fail("unknown");
  if (!session.is_planning()) note["recorded"].fail("no plan is running");
  if (note.has("results")) {
    session.keep_results(note["results"].text());
  } else {
    (void)session.finish_plan();
  }
}

void follow_line(const std::string& line, const CommandScope& scope, Replayed& replayed) {
  const Request request = read_request(line);
  if (request.json && is_note(*request.json)) {
    follow_note(request.json->root(), scope.session);
    return;
  }
  if (!request.json) throw InputError(*request.error);
  const std::string reply = reply_to(request, scope);
  if (!nlohmann::json::parse(reply)["ok"].get<bool>()) ++replayed.refused;
  replayed.replies.push_back(reply);
}

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
  const CommandScope scope{.session = session, .cancels = false};
  Replayed replayed;
  if (watch) watch(session);
  std::istringstream lines(recording);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    context.cancellation.check();
    if (line.empty()) continue;
    const std::uint64_t before = session.revision();
    try {
      follow_line(line, scope, replayed);
    } catch (const InputError& error) {
      throw InputError({file, "line " + std::to_string(number), error.what()});
    }
    if (watch && session.revision() != before) watch(session);
  }
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
