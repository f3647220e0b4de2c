// The program as a server of live sessions.
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/program/program.h"
#include "tests/program/running_program.h"
#include "tests/support/socket_client.h"

namespace prehend::test {
namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// Of "serving 127.0.0.1 port N: ...".
std::uint16_t port_in(const std::string& words) {
  const std::string before = " port ";
  const std::size_t at = words.find(before);
  if (at == std::string::npos) return 0;
  return static_cast<std::uint16_t>(std::stoi(words.substr(at + before.size())));
}

// The reply to a request; events that come before it are left out.
nlohmann::json reply_to(SocketClient& client, const std::string& request) {
  client.send(request + "\n");
  while (true) {
    const std::string line = client.line();
    const nlohmann::json answer = nlohmann::json::parse(line, nullptr, false);
    if (answer.is_discarded() || answer.contains("ok")) return answer;
  }
}

TEST(Serve, AnswersRecordsAndEndsOnCtrlC) {
  const std::filesystem::path folder = fresh_folder("serve");
  const std::string recording = (folder / "session.jsonl").string();
  RunningProgram program({"serve", "--tcp", "0", "--record", recording}, folder);
  ASSERT_TRUE(program.wait_for_line("Ctrl-C"));
  const std::uint16_t port = port_in(content_of(folder / "out"));
  ASSERT_GT(port, 0);
  SocketClient client(port);
  ASSERT_TRUE(client.is_connected());
  EXPECT_EQ(reply_to(client, R"({"id": 1, "command": "hello"})")["ok"], true);
  EXPECT_EQ(reply_to(client, R"({"id": 2, "command": "fly"})")["ok"], false);
  EXPECT_EQ(reply_to(client, R"({"id": 3, "command": "state"})")["id"], 3);
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 130);
  EXPECT_EQ(client.line(), "(closed)");
  EXPECT_NE(content_of(recording).find("hello"), std::string::npos);
}

TEST(Serve, RefusesAPortThatIsTaken) {
  const std::filesystem::path folder = fresh_folder("serve_taken");
  RunningProgram first({"serve", "--tcp", "0"}, folder);
  ASSERT_TRUE(first.wait_for_line("Ctrl-C"));
  const std::string port = std::to_string(port_in(content_of(folder / "out")));
  const std::filesystem::path other = fresh_folder("serve_taken_too");
  RunningProgram second({"serve", "--tcp", port}, other);
  std::string rest;
  EXPECT_EQ(second.wait(rest), 2);
  EXPECT_NE(rest.find(port), std::string::npos) << rest;
}

}  // namespace
}  // namespace prehend::test
