// The commands as tools of an assistant: what it asks is answered once, in JSON-RPC 2.0.
#include "planner/live/protocol/mcp_client.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <set>

#include <gtest/gtest.h>

#include "planner/live/protocol/session_endpoint.h"
#include "tests/planner/live/protocol/listening_client.h"

namespace prehend::test {
namespace {

// What an assistant sends and gets.
class Assistant {
 public:
  Reply next() {
    std::unique_lock hold(lock_);
    came_.wait(hold, [this] { return !messages_.empty(); });
    Reply message = std::move(messages_.front());
    messages_.pop_front();
    return message;
  }
  void send(const Reply& message) { client_.receive(message.dump()); }
  void send_text(const std::string& text) { client_.receive(text); }
  // The answer to a call of a method; notifications before it are dropped.
  Reply ask(const std::string& method, const Reply& params = Reply::object()) {
    send({{"jsonrpc", "2.0"}, {"id", "q"}, {"method", method}, {"params", params}});
    for (;;) {
      Reply message = next();
      if (message.contains("id")) return message;
    }
  }
  // The result of a tool, which is JSON text.
  Reply call(const std::string& tool, const Reply& arguments = Reply::object()) {
    const Reply answer = ask("tools/call", {{"name", tool}, {"arguments", arguments}});
    EXPECT_EQ(answer["result"]["isError"], false) << answer;
    return Reply::parse(answer["result"]["content"][0]["text"].get<std::string>());
  }
  std::size_t left() {
    const std::lock_guard hold(lock_);
    return messages_.size();
  }
  void finish() { client_.finish(); }

 private:
  std::mutex lock_;
  std::condition_variable came_;
  std::deque<Reply> messages_;
  SessionEndpoint endpoint_{{}};
  McpClient client_{endpoint_, "1.2.3", [this](const std::string& line) {
                      const std::lock_guard hold(lock_);
                      EXPECT_EQ(line.find('\n'), std::string::npos);
                      messages_.push_back(Reply::parse(line));
                      EXPECT_EQ(messages_.back()["jsonrpc"], "2.0");
                      came_.notify_all();
                    }};
};

TEST(Mcp, SaysWhoItIsInAVersionThatBothKnow) {
  Assistant assistant;
  const Reply old = assistant.ask("initialize", {{"protocolVersion", "2024-11-05"}})["result"];
  EXPECT_EQ(old["protocolVersion"], "2024-11-05");
  EXPECT_EQ(old["serverInfo"]["name"], "prehend");
  EXPECT_EQ(old["serverInfo"]["version"], "1.2.3");
  EXPECT_TRUE(old["capabilities"].contains("tools"));
  const Reply future = assistant.ask("initialize", {{"protocolVersion", "2999-01-01"}})["result"];
  EXPECT_EQ(future["protocolVersion"], "2025-06-18");
  assistant.send({{"jsonrpc", "2.0"}, {"method", "notifications/initialized"}});
  EXPECT_EQ(assistant.ask("ping")["result"], Reply::object());
}

// Names that all clients take, and schemas that need nothing else.
TEST(Mcp, EachCommandIsATool) {
  Assistant assistant;
  const Reply tools = assistant.ask("tools/list")["result"]["tools"];
  ASSERT_EQ(tools.size(), commands().size());
  std::set<std::string> names;
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const auto name = tools[i]["name"].get<std::string>();
    EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyz_"), std::string::npos) << name;
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_GT(tools[i]["description"].get<std::string>().size(), 10U);
    const Reply& schema = tools[i]["inputSchema"];
    EXPECT_EQ(schema["type"], "object");
    EXPECT_EQ(schema["properties"].size(), commands()[i].fields.size());
    EXPECT_FALSE(schema["properties"].contains("command"));
    const bool refers = schema.dump().find("#/$defs/pose") != std::string::npos;
    EXPECT_EQ(refers, schema.contains("$defs")) << name;
  }
}

TEST(Mcp, AnAssistantPlansAGrasp) {
  Assistant assistant;
  assistant.call("scene_new", {{"hand", "parallel_jaw"}});
  assistant.call("object_set", {{"generate", "cylinder"}, {"triangles", 600}});
  // The answer comes when the plan has ended, news of it before.
  assistant.send({{"jsonrpc", "2.0"},
                  {"id", 7},
                  {"method", "tools/call"},
                  {"params",
                   {{"name", "plan_start"},
                    {"arguments", {{"trials", 60}, {"top", 3}}},
                    {"_meta", {{"progressToken", "p"}}}}}});
  int news = 0;
  Reply answer = assistant.next();
  while (!answer.contains("id")) {
    EXPECT_EQ(answer["method"], "notifications/progress");
    EXPECT_EQ(answer["params"]["progressToken"], "p");
    ++news;
    answer = assistant.next();
  }
  EXPECT_EQ(answer["id"], 7);
  EXPECT_GT(news, 0);
  const Reply end = Reply::parse(answer["result"]["content"][0]["text"].get<std::string>());
  EXPECT_EQ(end["status"], "complete");
  const Reply grasps = assistant.call("plan_results");
  EXPECT_EQ(grasps["grasps"].size(), end["size"]);
  EXPECT_GT(grasps["grasps"][0]["epsilon"], 0.0);
}

TEST(Mcp, WhatACommandRefusesIsAnErrorOfTheTool) {
  Assistant assistant;
  const Reply answer =
      assistant.ask("tools/call", {{"name", "hand_move"}, {"arguments", {{"nose", 1}}}});
  EXPECT_EQ(answer["result"]["isError"], true);
  EXPECT_NE(answer["result"]["content"][0]["text"].get<std::string>().find("nose"),
            std::string::npos);
}

TEST(Mcp, WhatIsNoRequestIsAnError) {
  Assistant assistant;
  const auto code_of = [&](const std::string& text) {
    assistant.send_text(text);
    return assistant.next()["error"]["code"].get<int>();
  };
  EXPECT_EQ(code_of("nonsense"), -32700);
  EXPECT_EQ(code_of(std::string(1000, '[')), -32700);
  EXPECT_EQ(code_of("[]"), -32600);
  EXPECT_EQ(code_of(R"({"id": 1, "method": "ping"})"), -32600);
  EXPECT_EQ(code_of(R"({"jsonrpc": "2.0", "id": {}, "method": "ping"})"), -32600);
  EXPECT_EQ(code_of(R"({"jsonrpc": "2.0", "id": 1, "method": "fly"})"), -32601);
  EXPECT_EQ(code_of(R"({"jsonrpc": "2.0", "id": 1, "method": "ping", "params": []})"), -32602);
  EXPECT_EQ(code_of(R"({"jsonrpc": "2.0", "id": 1, "method": "tools/call"})"), -32602);
  EXPECT_EQ(code_of(R"({"jsonrpc": "2.0", "id": 1, "method": "tools/call",
                        "params": {"name": "state", "arguments": {"command": "undo"}}})"),
            -32602);
  // A notification has no answer, whatever it is.
  assistant.send({{"jsonrpc", "2.0"}, {"method", "fly"}});
  EXPECT_EQ(assistant.ask("ping")["result"], Reply::object());
  EXPECT_EQ(assistant.left(), 0U);
}

TEST(Mcp, ACancelledPlanEndsAndIsNotAnswered) {
  Assistant assistant;
  assistant.call("scene_load", {{"scene", "mug"}});
  assistant.send({{"jsonrpc", "2.0"},
                  {"id", 7},
                  {"method", "tools/call"},
                  {"params", {{"name", "plan_start"}, {"arguments", {{"trials", 1000000}}}}}});
  assistant.send(
      {{"jsonrpc", "2.0"}, {"method", "notifications/cancelled"}, {"params", {{"requestId", 7}}}});
  assistant.finish();
  const Reply state = assistant.ask("tools/call", {{"name", "state"}});
  EXPECT_EQ(state["id"], "q");
  EXPECT_EQ(assistant.left(), 0U);
}

}  // namespace
}  // namespace prehend::test
