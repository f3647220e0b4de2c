#include "benchmarks/live_soak/judge_reply.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace prehend::live_soak {
namespace {

// Fields that may be null: nothing is there. Everywhere else null is what a number that is not
// finite becomes in JSON.
constexpr std::array<std::string_view, 25> kMayBeNull = {
    "problem", "object",  "platform", "arm",     "outcome", "time",  "link",     "by",    "blocked",
    "limit",   "status",  "path",     "volume",  "id",      "axis",  "before",   "after", "drive",
    "results", "surface", "planned",  "touches", "fixed",   "share", "distances"};

// Where a null stands that should be a number; empty: nowhere.
std::string null_in(const Json& json, const std::string& place) {
  if (json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      const std::string here = place + "[" + std::to_string(i) + "]";
      if (json[i].is_null()) return here;
      if (std::string inner = null_in(json[i], here); !inner.empty()) return inner;
    }
  } else if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      std::string here = place;
      here.append(".").append(key);
      const bool may_be = std::find(kMayBeNull.begin(), kMayBeNull.end(), key) != kMayBeNull.end();
      if (value.is_null() && !may_be) return here;
      if (std::string inner = null_in(value, here); !inner.empty()) return inner;
    }
  }
  return {};
}

std::string fault_of_error(const Json& error) {
  for (const char* part : {"field", "problem", "value"}) {
    if (!error.contains(part) || !error[part].is_string()) return "an error without its parts";
  }
  const std::string problem = error["problem"];
  if (problem.empty()) return "an error without a problem";
  for (const char* ours : {"internal error", "out of memory"}) {
    if (problem.find(ours) != std::string::npos) return "an error of ours: " + problem;
  }
  return {};
}

}  // namespace

std::string fault_of_reply(const Json& reply, int id) {
  if (!reply.is_object() || !reply.contains("ok") || !reply["ok"].is_boolean()) return "no reply";
  if (!reply.contains("id") || reply["id"] != id) return "a reply to something else";
  if (reply["ok"] == false) {
    return reply.contains("error") ? fault_of_error(reply["error"]) : "no error";
  }
  if (!reply.contains("result") || !reply["result"].is_object()) return "no result";
  const std::string place = null_in(reply["result"], "result");
  return place.empty() ? "" : "not a number: " + place;
}

std::string fault_of_event(const Json& event) {
  if (!event["event"].is_string()) return "an event without a name";
  const std::string place = null_in(event, "event");
  return place.empty() ? "" : "not a number: " + place;
}

Json without_history(Json state) {
  for (const char* field : {"revision", "undo", "redo", "planning", "finding_path"}) {
    state.erase(field);
  }
  return state;
}

}  // namespace prehend::live_soak
