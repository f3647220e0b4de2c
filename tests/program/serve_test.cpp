// The program as a server of live sessions.
#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/random.h"
#include "tests/program/program.h"
#include "tests/program/running_program.h"
#include "tests/support/repeats.h"
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

// All that is asked is answered before the program ends with its input, and nothing else is said.
TEST(Mcp, AnswersOnTheStandardOutput) {
  const std::filesystem::path folder = fresh_folder("mcp");
  std::ofstream(folder / "in") << R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{}})"
                               << "\n"
                               << R"({"jsonrpc":"2.0","method":"notifications/initialized"})"
                               << "\n"
                               << R"({"jsonrpc":"2.0","id":2,"method":"tools/call","params":)"
                               << R"({"name":"plan_start","arguments":{"trials":30}}})"
                               << "\n";
  const ProgramRun run = run_program("mcp --scene mug < " + (folder / "in").string());
  EXPECT_EQ(run.status, 0) << run.err;
  std::istringstream lines(run.out);
  std::string line;
  for (const int id : {1, 2}) {
    ASSERT_TRUE(std::getline(lines, line));
    const nlohmann::json answer = nlohmann::json::parse(line);
    EXPECT_EQ(answer["id"], id);
    EXPECT_TRUE(answer.contains("result")) << line;
  }
  EXPECT_NE(line.find("\\\"status\\\""), std::string::npos) << line;
  EXPECT_FALSE(std::getline(lines, line));
  expect_refused(run_program("mcp --scene nowhere < /dev/null"), "nowhere");
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

TEST(Serve, KilledAtAnyMomentItLeavesAWholeSceneAndARecordingThatReplays) {
  Random random(38);
  int recorded = 0;
  for (int i = 0; i < repeats(12); ++i) {
    const std::filesystem::path folder = fresh_folder("serve_killed");
    const std::filesystem::path recording = folder / "session.jsonl";
    const std::filesystem::path scene = folder / "scene.json";
    RunningProgram program({"serve", "--tcp", "0", "--scene", "hammer", "--record",
                            recording.string(), "--folder", folder.string()},
                           folder);
    ASSERT_TRUE(program.wait_for_line("Ctrl-C"));
    SocketClient client(port_in(content_of(folder / "out")));
    ASSERT_TRUE(client.is_connected());
    std::string requests;
    for (int k = 1; k <= 100; ++k) {
      requests += R"({"command": "object.change", "mass": )" + std::to_string(k) + "}\n" +
                  R"({"command": "scene.save", "file": ")" + scene.string() + "\"}\n";
    }
    client.send(requests);
    while (!std::filesystem::exists(scene)) ::usleep(200);
    ::usleep(static_cast<unsigned>(random.integer(0, 30000)));
    program.send(SIGKILL);
    std::string rest;
    EXPECT_EQ(program.wait(rest), -1);
    EXPECT_EQ(run_program("inspect '" + scene.string() + "'").status, 0) << content_of(scene);
    std::istringstream lines(content_of(recording));
    for (std::string line; std::getline(lines, line); ++recorded) {
      EXPECT_TRUE(nlohmann::json::accept(line)) << line;
    }
    const ProgramRun replayed = run_program("replay '" + recording.string() + "'");
    EXPECT_EQ(replayed.status, 0) << replayed.err;
  }
  EXPECT_GT(recorded, 10);
}

// As on a full disk: the file may not become larger than that (ulimit -f counts KiB).
TEST(Serve, ARecordingThatCannotGoOnIsToldOfAndEndsWithAWholeLine) {
  const std::filesystem::path folder = fresh_folder("serve_full");
  const std::filesystem::path recording = folder / "session.jsonl";
  RunningProgram program({"serve", "--tcp", "0", "--record", recording.string()}, folder,
                         rlim_t{4096});
  ASSERT_TRUE(program.wait_for_line("Ctrl-C"));
  SocketClient client(port_in(content_of(folder / "out")));
  ASSERT_TRUE(client.is_connected());
  const std::string request = R"({"id": ")" + std::string(600, 'x') + R"(", "command": "state"})";
  bool was_told = false;
  for (int i = 0; i < 20; ++i) {
    client.send(request + "\n");
    for (std::string line = client.line(); line.find("\"ok\":true") == std::string::npos;
         line = client.line()) {
      ASSERT_NE(line, "(closed)");
      was_told = was_told || line.find("\"event\":\"recording\"") != std::string::npos;
    }
  }
  EXPECT_TRUE(was_told);
  program.send(SIGINT);
  std::string rest;
  EXPECT_EQ(program.wait(rest), 1);
  // On the terminal once.
  const std::size_t told = rest.find(recording.string() + ": the recording has ended");
  EXPECT_NE(told, std::string::npos) << rest;
  EXPECT_EQ(rest.find("the recording", told + recording.string().size() + 10), std::string::npos);
  const std::string content = content_of(recording);
  EXPECT_GT(content.size(), 3000U);
  EXPECT_TRUE(content.ends_with("}\n")) << content;
  std::istringstream lines(content);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(nlohmann::json::accept(line)) << line;
  }
}

TEST(Serve, CommandsBehindAnotherProtocolAreNotCarriedOut) {
  const std::filesystem::path folder = fresh_folder("serve_strangers");
  RunningProgram program({"serve", "--tcp", "0", "--graspit", "0", "--scene", "mug"}, folder);
  ASSERT_TRUE(program.wait_for_line("Ctrl-C"));
  const std::string words = content_of(folder / "out");
  const std::uint16_t lines = port_in(words);
  const std::uint16_t graspit = port_in(words.substr(words.find('\n')));
  const std::string command = R"({"command": "pin.add", "name": "a"})";
  const std::string hello_of_tls = std::string("\x16\x03\x01\x02\x00\x01", 6) + "\n";
  for (const std::string& before :
       {hello_of_tls, std::string("POST / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n"),
        std::string("[]\n"), std::string("{\"command\": \n"), std::string("getDOFVals ALL\n")}) {
    SocketClient client(lines);
    client.send(before + command + "\n");
    const std::string answer = client.rest();
    // One reply; the event of the scene that was opened may come as well.
    const std::size_t refused = answer.find("\"ok\":false");
    EXPECT_NE(refused, std::string::npos) << answer;
    EXPECT_EQ(answer.find("\"ok\":"), refused) << answer;
    EXPECT_EQ(answer.find("\"ok\":", refused + 1), std::string::npos) << answer;
  }
  for (const std::string& before :
       {hello_of_tls, std::string("POST / HTTP/1.1\r\n"), std::string("{}\n")}) {
    SocketClient client(graspit);
    client.send(before + "getDOFVals ALL\n");
    const std::string answer = client.rest();
    EXPECT_TRUE(answer.starts_with("Error: ")) << answer;
    EXPECT_EQ(std::count(answer.begin(), answer.end(), '\n'), 1) << answer;
  }
  SocketClient client(lines);
  EXPECT_EQ(reply_to(client, R"({"command": "state"})")["result"]["pins"].size(), 0U);
}

}  // namespace
}  // namespace prehend::test
