#include "planner/live/protocol/mcp_client.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "planner/live/protocol/protocol_schema.h"
#include "planner/live/protocol/request.h"
#include "sim/base/json/json_depth.h"

namespace prehend {
namespace {

// Of JSON-RPC 2.0.
constexpr int kNoJson = -32700;
constexpr int kNoRequest = -32600;
constexpr int kNoMethod = -32601;
constexpr int kBadParameters = -32602;

// Of the Model Context Protocol, the newest last; what is used of them is the same in all.
constexpr std::array<std::string_view, 3> kVersions = {"2024-11-05", "2025-03-26", "2025-06-18"};

// That wait for their answers: more are not read until one of them is answered.
constexpr std::size_t kMostCalls = 100;

constexpr const char* kInstructions =
    "Plans robot grasps. scene_load or object_set and hand_choose say what is to be grasped with "
    "what; plan_start plans; plan_results lists the grasps, best first (epsilon: larger is "
    "better). Lengths are in m, angles in rad.";

// Names of tools may not have dots.
std::string tool_name(std::string_view command) {
  std::string name(command);
  std::replace(name.begin(), name.end(), '.', '_');
  return name;
}

const Command* command_of(const std::string& tool) {
  for (const Command& command : commands()) {
    if (tool_name(command.name) == tool) return &command;
  }
  return nullptr;
}

// What begins something that an event ends.
std::string_view ended_by(std::string_view command) {
  if (command == "plan.start") return "plan";
  return command == "path.plan" ? "path" : "";
}

ProtocolJson tools() {
  ProtocolJson list = ProtocolJson::array();
  for (const Command& command : commands()) {
    std::string description =
        std::string(command.summary) + " Replies " + std::string(command.result) + ".";
    if (!ended_by(command.name).empty()) description += " Answered when it has ended.";
    list.push_back({{"name", tool_name(command.name)},
                    {"description", description},
                    {"inputSchema", command_schema(command)},
                    {"annotations", {{"readOnlyHint", command.kind == CommandKind::query}}}});
  }
  return {{"tools", list}};
}

bool is_id(const ProtocolJson& id) { return id.is_string() || id.is_number_integer(); }

}  // namespace

McpClient::McpClient(Endpoint& endpoint, std::string version,
                     std::function<void(std::string)> write)
    : endpoint_(endpoint), version_(std::move(version)), write_(std::move(write)) {
  client_ = endpoint_.connect([this](const std::string& text) { take(text); });
}

McpClient::~McpClient() { endpoint_.disconnect(client_); }

void McpClient::finish() {
  std::unique_lock lock(lock_);
  has_room_.wait(lock, [this] { return calls_.empty(); });
}

void McpClient::receive(const std::string& line) {
  if (json_depth(line) > kDeepestJson) return send_error(nullptr, kNoJson, "nested too deep");
  const Json message = Json::parse(line, nullptr, false);
  if (message.is_discarded()) return send_error(nullptr, kNoJson, "not JSON");
  const bool is_sound = message.is_object() && message.value("jsonrpc", "") == "2.0" &&
                        message.contains("method") && message["method"].is_string() &&
                        (!message.contains("id") || is_id(message["id"]));
  if (!is_sound) return send_error(nullptr, kNoRequest, "not a request of JSON-RPC 2.0");
  handle(message);
}

void McpClient::handle(const Json& message) {
  const auto method = message["method"].get<std::string>();
  const Json params = message.contains("params") ? message["params"] : Json::object();
  if (!message.contains("id")) {
    if (method == "notifications/cancelled") cancel(params);
    return;  // nothing is answered to notifications
  }
  const Json& id = message["id"];
  if (!params.is_object()) return send_error(id, kBadParameters, "params: must be an object");
  if (method == "ping") return send_result(id, Json::object());
  if (method == "tools/list") return send_result(id, tools());
  if (method == "tools/call") return call_tool(id, params);
  if (method != "initialize") return send_error(id, kNoMethod, "no method " + method);
  const Json asked = params.contains("protocolVersion") ? params["protocolVersion"] : Json();
  std::string_view version = kVersions.back();
  for (const std::string_view known : kVersions) {
    if (asked == known) version = known;
  }
  send_result(id, {{"protocolVersion", version},
                   {"capabilities", {{"tools", Json::object()}}},
                   {"serverInfo", {{"name", "prehend"}, {"version", version_}}},
                   {"instructions", kInstructions}});
}

void McpClient::call_tool(const Json& id, const Json& params) {
  const bool is_named = params.contains("name") && params["name"].is_string();
  const std::string name = is_named ? params["name"].get<std::string>() : "";
  const Command* command = command_of(name);
  if (command == nullptr) return send_error(id, kBadParameters, "no tool " + name);
  Json request = params.contains("arguments") ? params["arguments"] : Json::object();
  if (!request.is_object() || request.contains("id") || request.contains("command")) {
    return send_error(id, kBadParameters, "arguments: must be an object of the fields of " + name);
  }
  Call call{.id = id, .command = std::string(command->name)};
  if (params.contains("_meta") && params["_meta"].is_object() &&
      params["_meta"].contains("progressToken")) {
    call.progress_token = params["_meta"]["progressToken"];
  }
  {
    std::unique_lock lock(lock_);
    has_room_.wait(lock, [this] { return calls_.size() < kMostCalls; });
    request["id"] = ++last_;
    calls_.emplace(last_, std::move(call));
  }
  request["command"] = command->name;
  endpoint_.receive(client_, message_text(request));
}

// What it began is ended by the command that does so; its own answer is dropped.
void McpClient::cancel(const Json& params) {
  if (!params.is_object() || !params.contains("requestId")) return;
  std::string_view ends;
  {
    const std::lock_guard lock(lock_);
    for (auto& [number, call] : calls_) {
      if (call.id != params["requestId"]) continue;
      call.is_cancelled = true;
      ends = ended_by(call.command);
    }
  }
  if (ends.empty()) return;
  // Its own reply has no number, and no call waits for it.
  endpoint_.receive(client_, message_text({{"command", std::string(ends) + ".cancel"}}));
}

void McpClient::take(const std::string& text) {
  const Json message = Json::parse(text);
  const std::lock_guard lock(lock_);
  if (message.contains("event")) {
    take_event(message);
  } else if (message["id"].is_number_integer()) {
    take_reply(message);
  }
}

void McpClient::take_event(const Json& event) {
  for (auto& [number, call] : calls_) {
    if (!call.is_waiting) continue;
    if (event["event"] == ended_by(call.command)) {
      Json end = event;
      end.erase("event");
      answer(call, message_text(end), event.value("status", "") == "failed");
      return forget(number);
    }
    if (event["event"] != "progress" || call.progress_token.is_null()) continue;
    write_(message_text({{"jsonrpc", "2.0"},
                         {"method", "notifications/progress"},
                         {"params",
                          {{"progressToken", call.progress_token},
                           {"progress", event.value("done", 0)},
                           {"total", event.value("total", 0)},
                           {"message", event.value("stage", "")}}}}));
  }
}

void McpClient::take_reply(const Json& reply) {
  const int number = reply["id"].get<int>();
  const auto found = calls_.find(number);
  if (found == calls_.end()) return;
  const bool is_ok = reply["ok"] == true;
  if (is_ok && !ended_by(found->second.command).empty()) {
    found->second.is_waiting = true;
    return;
  }
  answer(found->second, message_text(is_ok ? reply["result"] : reply["error"]), !is_ok);
  forget(number);
}

void McpClient::forget(int number) {
  calls_.erase(number);
  has_room_.notify_all();
}

void McpClient::answer(const Call& call, const std::string& text, bool is_error) {
  if (call.is_cancelled) return;
  const Json content = Json::array({{{"type", "text"}, {"text", text}}});
  write_(message_text({{"jsonrpc", "2.0"},
                       {"id", call.id},
                       {"result", {{"content", content}, {"isError", is_error}}}}));
}

void McpClient::send(const Json& message) {
  const std::lock_guard lock(lock_);
  write_(message_text(message));
}

void McpClient::send_result(const Json& id, Json result) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void McpClient::send_error(const Json& id, int code, const std::string& problem) {
  send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", problem}}}});
}

}  // namespace prehend
