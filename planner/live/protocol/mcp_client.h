// The commands of the protocol as tools of the Model Context Protocol, by which assistants use
// programs (modelcontextprotocol.io, versions 2024-11-05 to 2025-06-18).
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "planner/live/protocol/command.h"
#include "planner/live/serve/endpoint.h"

namespace prehend {

// A client of an endpoint that speaks JSON-RPC 2.0, a message a line. Each command is a tool, with
// "_" for "." in its name. A call of plan.start or path.plan is answered when the plan or the
// search has ended; a cancelled one ends it. `write` gets one line at a time, from any thread.
class McpClient {
 public:
  // `version`: of this program.
  McpClient(Endpoint& endpoint, std::string version, std::function<void(std::string)> write);
  ~McpClient();
  McpClient(const McpClient&) = delete;
  McpClient& operator=(const McpClient&) = delete;

  void receive(const std::string& line);
  // Waits until all calls are answered.
  void finish();

 private:
  using Json = ProtocolJson;

  // A call of a tool that is not answered yet.
  struct Call {
    Json id;                    // of JSON-RPC
    std::string command;        // that it carries out
    Json progress_token;        // null: none wants to hear of progress
    bool is_waiting = false;    // what it began runs
    bool is_cancelled = false;  // nobody waits for its answer
  };

  void handle(const Json& message);
  void call_tool(const Json& id, const Json& params);
  void cancel(const Json& params);
  void take(const std::string& text);
  void take_event(const Json& event);
  void take_reply(const Json& reply);
  void answer(const Call& call, const std::string& text, bool is_error);
  void send(const Json& message);
  void send_result(const Json& id, Json result);
  void send_error(const Json& id, int code, const std::string& problem);
  void forget(int number);

  Endpoint& endpoint_;
  std::string version_;
  std::function<void(std::string)> write_;
  std::mutex lock_;  // of what follows, and held while something is written
  std::condition_variable has_room_;
  std::map<int, Call> calls_;  // by the id of the request of the endpoint
  int last_ = 0;
  ClientId client_ = 0;
};

}  // namespace prehend
