#include <array>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "tests/support/echo_server.h"

namespace prehend::test {
namespace {

constexpr int kMessages = 2500;  // of each of four clients

// What a client sends at a time, and what it has to hear of it.
struct Said {
  std::string bytes;
  std::vector<std::string> answers;
};

std::string letters(Random& random, std::size_t most) {
  std::string text;
  for (std::size_t i = 1 + random.index(most); i > 0; --i) {
    text += static_cast<char>('a' + random.index(26));
  }
  return text;
}

Said line_said(Random& random, int number) {
  const std::string text = std::to_string(number) + letters(random, 40);
  switch (random.index(10)) {
    case 0:
      return {"?" + text + "\n", {"?" + text}};
    case 1:
      return {"\n\r\n" + text + "\r\n", {text}};
    case 2:
      return {"\t\xC3\xBC" + text + "\n", {"\t\xC3\xBC" + text}};
    case 3:
      if (number % 20 != 0) break;
      return {std::string(EchoServer::kLargest + 1 + random.index(200000), 'x') + "\n",
              {json_error_line("longer than 100000 bytes")}};
    case 4:
      return {std::string(1 + random.index(300), '[') + "\n" + text + "\n", {"", text}};
    default:
      break;
  }
  return {text + "\n", {text}};
}

// Sends all in pieces of any size, on a thread of its own, and reads what comes meanwhile.
void run_line_client(std::uint16_t port, std::uint64_t seed) {
  Random random(seed);
  std::string bytes = "first\n";
  std::vector<std::string> answers = {"first"};
  for (int i = 0; i < kMessages; ++i) {
    Said said = line_said(random, i);
    if (said.answers.front().empty())
      said.answers.front() = said.bytes.substr(0, said.bytes.find('\n'));
    bytes += said.bytes;
    answers.insert(answers.end(), said.answers.begin(), said.answers.end());
  }
  SocketClient client(port);
  std::thread sender([&] {
    for (std::string_view rest = bytes; !rest.empty();) {
      const std::size_t size = std::min(rest.size(), 1 + random.index(20000));
      ASSERT_TRUE(client.send(rest.substr(0, size)));
      rest.remove_prefix(size);
    }
  });
  for (const std::string& answer : answers) EXPECT_EQ(client.line(), answer) << "seed " << seed;
  sender.join();
  // Nothing is answered twice.
  client.end_sending();
  EXPECT_EQ(client.rest(), "");
}

void run_web_socket(const EchoServer& echo, std::uint64_t seed) {
  Random random(seed);
  WebSocketClient client = echo.web_socket();
  std::vector<std::string> answers;
  for (int i = 0; i < kMessages; ++i) {
    const std::string text = std::to_string(i) + letters(random, 200);
    const std::size_t cut = random.index(text.size());
    if (random.index(3) == 0) {
      client.send_frame(WebSocketClient::kText, text.substr(0, cut), false);
      client.send_frame(WebSocketClient::kMore, text.substr(cut));
    } else if (random.index(10) == 0) {
      client.send_frame(WebSocketClient::kBinary, "\xFF" + text);
      answers.push_back(json_error_line("not UTF-8"));
      continue;
    } else {
      client.send_frame(WebSocketClient::kText, text);
    }
    answers.push_back(text);
    // So that both sides have something to do.
    if (answers.size() < 50) continue;
    for (const std::string& answer : answers) EXPECT_EQ(client.next_frame().payload, answer);
    answers.clear();
  }
  for (const std::string& answer : answers) EXPECT_EQ(client.next_frame().payload, answer);
}

TEST(ServerSoak, TenThousandMessagesOfFourClientsAtOnceAreAnsweredOnceEach) {
  EchoServer echo([](ServerOptions& options) { options.largest_waiting = std::size_t{16} << 20U; });
  std::vector<std::thread> clients;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    clients.emplace_back([&, seed] { run_line_client(echo.ports.lines.at(0), seed); });
  }
  clients.emplace_back([&] { run_web_socket(echo, 4); });
  for (std::thread& client : clients) client.join();
  echo.endpoint.wait_for_disconnected(4);
  for (const auto& [id, client] : echo.endpoint.clients()) EXPECT_EQ(client.disconnected, 1);
}

// Random bytes to all doors: whatever comes of it, the server goes on.
TEST(ServerSoak, RandomBytesDoNoHarm) {
  EchoServer echo;
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    std::string bytes;
    for (std::size_t k = random.index(2000); k > 0; --k) {
      bytes += static_cast<char>(random.index(256));
    }
    const bool to_socket = random.index(3) == 0;
    if (to_socket) {
      WebSocketClient client = echo.web_socket();
      client.socket().send(bytes);
      client.socket().end_sending();
      client.socket().rest();
    } else {
      SocketClient client = echo.line_client();
      client.send(bytes);
      client.end_sending();
      client.rest();
    }
  }
  SocketClient client = echo.line_client();
  client.send("still there\n");
  EXPECT_EQ(client.line(), "still there");
}

TEST(ServerSoak, ManyClientsAtOnceAreServed) {
  constexpr int kClients = 100;
  EchoServer echo([](ServerOptions& options) { options.clients = 2 * kClients; });
  std::vector<SocketClient> clients;
  for (int i = 0; i < kClients; ++i) clients.push_back(echo.line_client());
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < kClients; ++i) {
      clients[static_cast<std::size_t>(i)].send(std::to_string(i) + "\n");
    }
    for (int i = 0; i < kClients; ++i) {
      EXPECT_EQ(clients[static_cast<std::size_t>(i)].line(), std::to_string(i));
    }
  }
}

}  // namespace
}  // namespace prehend::test
