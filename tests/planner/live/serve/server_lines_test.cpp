#include <algorithm>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "tests/support/echo_server.h"
#include "tests/support/peak_memory.h"

namespace prehend::test {
namespace {

const std::string kTooLong = R"({"ok":false,"error":{"problem":"longer than 100000 bytes"}})";
const std::string kNotText = R"({"ok":false,"error":{"problem":"not text in UTF-8"}})";
const std::string kNoRequest =
    R"({"ok":false,"error":{"problem":"not a request of this protocol"}})";

TEST(ServerLines, PipelinedLinesAreAnsweredInOrder) {
  const EchoServer echo;
  SocketClient client = echo.line_client();
  client.send("one\ntwo\r\n\n\r\nthree\n");
  EXPECT_EQ(client.line(), "one");
  EXPECT_EQ(client.line(), "two");
  EXPECT_EQ(client.line(), "three");
}

TEST(ServerLines, ALineMayComeByteByByte) {
  const EchoServer echo;
  SocketClient client = echo.line_client();
  for (const char byte : std::string("gr\xC3\xBC\xC3\x9F\r\n")) client.send({&byte, 1});
  EXPECT_EQ(client.line(), "gr\xC3\xBC\xC3\x9F");
}

TEST(ServerLines, ALineThatIsTooLongIsRefusedAndTheNextOneServed) {
  EchoServer echo;
  SocketClient client = echo.line_client();
  client.send(std::string(EchoServer::kLargest, 'x') + "\n");
  EXPECT_EQ(client.line().size(), EchoServer::kLargest);
  client.send(std::string(EchoServer::kLargest + 1, 'x') + "\nnext\n");
  EXPECT_EQ(client.line(), kTooLong);
  EXPECT_EQ(client.line(), "next");
  EXPECT_EQ(echo.endpoint.clients().at(1).received.size(), 2U);
}

TEST(ServerLines, AHundredMegabytesAreRefusedBeforeTheirEndAndNotKept) {
  const EchoServer echo;
  SocketClient client = echo.line_client();
  client.send("first\n");
  EXPECT_EQ(client.line(), "first");
  const std::string piece(1000000, 'x');
  client.send(piece);
  EXPECT_EQ(client.line(), kTooLong);
  const long before = peak_memory();
  for (int i = 0; i < 99; ++i) ASSERT_TRUE(client.send(piece));
  client.send("\nnext\n");
  EXPECT_EQ(client.line(), "next");
  // Room for what else the process does; a kept line would take a hundred thousand.
  EXPECT_LE(peak_memory() - before, 20000);
}

TEST(ServerLines, WhatIsNotTextEndsTheConnection) {
  EchoServer echo;
  int clients = 0;
  for (const std::string& bad : {std::string("\xFF\xFE"), std::string("a\0b", 3),
                                 std::string("a\x1B[2Jb"), std::string("a\rb")}) {
    for (const bool is_first : {true, false}) {
      SocketClient client = echo.line_client();
      client.send((is_first ? "" : "one\n") + bad + "\nnext\n");
      EXPECT_EQ(client.rest(), (is_first ? "" : "one\n") + kNotText + "\n");
      echo.endpoint.wait_for_disconnected(++clients);
      EXPECT_EQ(echo.endpoint.clients().at(static_cast<ClientId>(clients)).received.size(),
                is_first ? 0U : 1U);
    }
  }
  SocketClient client = echo.line_client();
  client.send("a\tb\n");
  EXPECT_EQ(client.line(), "a\tb");
}

// A web page can make a browser send requests to any port, with lines of its own inside.
TEST(ServerLines, WhoBeginsWithAnotherProtocolIsDisconnected) {
  EchoServer echo;
  SocketClient client = echo.line_client();
  client.send("\n\r\n?ET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n{\"command\":\"quit\"}\n" +
              std::string(300000, 'x') + "\nlast\n");
  EXPECT_EQ(client.rest(), kNoRequest + "\n");
  SocketClient long_one = echo.line_client();
  long_one.send(std::string(2 * EchoServer::kLargest, 'x') + "\nline\n");
  EXPECT_EQ(long_one.rest(), kTooLong + "\n");
  echo.endpoint.wait_for_disconnected(2);
  for (const auto& [id, client_seen] : echo.endpoint.clients()) {
    EXPECT_TRUE(client_seen.received.empty());
  }
  // Later lines may be anything that is text.
  SocketClient other = echo.line_client();
  other.send("one\n?two\n");
  EXPECT_EQ(other.line(), "one");
  EXPECT_EQ(other.line(), "?two");
}

TEST(ServerLines, TheFirstLineAfterATokenIsLookedAtAsWell) {
  EchoServer echo([](ServerOptions& options) { options.lines[0].needs_token = true; });
  SocketClient client = echo.line_client();
  client.send("secret\n?ET /\nnext\n");
  EXPECT_EQ(client.rest(), kNoRequest + "\n");
  EXPECT_TRUE(echo.endpoint.clients().at(1).received.empty());
}

TEST(ServerLines, ACutLineIsNoMessageAndWhatWaitsIsStillSent) {
  EchoServer echo;
  SocketClient client = echo.line_client();
  client.send("one\ntwo\nthr");
  client.end_sending();
  EXPECT_EQ(client.rest(), "one\ntwo\n");
  echo.endpoint.wait_for_disconnected(1);
  EXPECT_EQ(echo.endpoint.clients().at(1).received.size(), 2U);
}

TEST(ServerLines, EventsReachAClientThatSaysNothing) {
  EchoServer echo;
  SocketClient client = echo.line_client();
  echo.endpoint.wait_until([](const auto& clients) { return clients.contains(1); });
  echo.endpoint.clients().at(1).send("event");
  EXPECT_EQ(client.line(), "event");
}

TEST(ServerLines, AClientThatNeverReadsIsDisconnectedAndStallsNobody) {
  EchoServer echo;
  SocketClient deaf = echo.line_client();
  deaf.read_little();
  echo.endpoint.wait_until([](const auto& clients) { return clients.contains(1); });
  const auto send = echo.endpoint.clients().at(1).send;
  SocketClient other = echo.line_client();
  // More than the system keeps for a connection, and the limit besides.
  for (int i = 0; i < 500; ++i) {
    send(std::string(65536, 'x'));
    other.send("still there\n");
    ASSERT_EQ(other.line(), "still there");
  }
  echo.endpoint.wait_for_disconnected(1);
  EXPECT_EQ(echo.endpoint.clients().at(1).disconnected, 1);
  other.send("still there\n");
  EXPECT_EQ(other.line(), "still there");
}

TEST(ServerLines, AClientThatAsksWithoutReadingIsDisconnected) {
  EchoServer echo;
  SocketClient deaf = echo.line_client();
  deaf.read_little();
  const std::string line = std::string(50000, 'x') + "\n";
  int sent = 0;
  while (deaf.send(line)) ++sent;
  EXPECT_GT(sent, 20);
  echo.endpoint.wait_for_disconnected(1);
}

TEST(ServerLines, AClientMayGoWhileItIsAnswered) {
  EchoServer echo;
  for (int i = 0; i < 50; ++i) {
    SocketClient client = echo.line_client();
    client.send(std::string(50000, 'x') + "\n" + std::string(50000, 'y') + "\n");
    client.bytes(static_cast<std::size_t>(i) * 1000);
  }
  echo.endpoint.wait_for_disconnected(50);
  for (const auto& [id, client] : echo.endpoint.clients()) {
    EXPECT_EQ(client.disconnected, 1);
    client.send("too late");
  }
}

TEST(ServerLines, OneClientTooManyIsToldSo) {
  EchoServer echo([](ServerOptions& options) { options.clients = 2; });
  SocketClient first = echo.line_client();
  SocketClient second = echo.line_client();
  for (SocketClient* client : {&first, &second}) {
    client->send("here\n");
    EXPECT_EQ(client->line(), "here");
  }
  SocketClient third = echo.line_client();
  EXPECT_EQ(third.rest(), R"({"ok":false,"error":{"problem":"too many clients"}})"
                          "\n");
  first.close();
  // Its place is free only after the endpoint was told.
  while (echo.server.connections() > 1) std::this_thread::yield();
  SocketClient fourth = echo.line_client();
  fourth.send("here\n");
  EXPECT_EQ(fourth.line(), "here");
}

TEST(ServerLines, TheTokenComesFirstWhereItIsNeeded) {
  EchoServer echo([](ServerOptions& options) { options.lines[0].needs_token = true; });
  SocketClient client = echo.line_client();
  client.send("secret\nhello\n");
  EXPECT_EQ(client.line(), "hello");
  SocketClient wrong = echo.line_client();
  wrong.send("wrong\nhello\n");
  EXPECT_EQ(wrong.rest(), R"({"ok":false,"error":{"problem":"the token is wrong"}})"
                          "\n");
  EXPECT_EQ(echo.endpoint.clients().size(), 1U);
}

TEST(ServerLines, ATokenMustNotTakeLong) {
  EchoServer echo([](ServerOptions& options) {
    options.lines[0].needs_token = true;
    options.handshake_time = 0.05;
  });
  SocketClient client = echo.line_client();
  client.send("secr");
  EXPECT_EQ(client.rest(), "");
  EXPECT_TRUE(echo.endpoint.clients().empty());
}

TEST(ServerLines, ListenersHaveTheirOwnEndpointsAndWords) {
  EchoEndpoint words;
  EchoServer echo([&](ServerOptions& options) {
    options.lines.push_back({.endpoint = &words, .largest_line = 10});
    options.lines[1].is_request = [](const std::string& line) { return line == "render"; };
    options.lines[1].refusal = [](const std::string& problem) { return "Error: " + problem; };
  });
  SocketClient client(echo.ports.lines.at(1));
  client.send("render\ngetDOFVals ALL\n\xFF\n");
  EXPECT_EQ(client.line(), "render");
  EXPECT_EQ(client.line(), "Error: longer than 10 bytes");
  EXPECT_EQ(client.line(), "Error: not text in UTF-8");
  EXPECT_TRUE(echo.endpoint.clients().empty());
  EXPECT_EQ(words.clients().size(), 1U);
}

class ThrowingEndpoint : public EchoEndpoint {
 public:
  void receive(ClientId id, std::string message) override {
    if (message == "throw") throw std::runtime_error("as asked");
    EchoEndpoint::receive(id, std::move(message));
  }
};

TEST(ServerLines, AnExceptionEndsItsClientOnly) {
  ThrowingEndpoint throwing;
  EchoServer echo([&](ServerOptions& options) { options.lines[0].endpoint = &throwing; });
  SocketClient one = echo.line_client();
  SocketClient other = echo.line_client();
  one.send("hello\n");
  EXPECT_EQ(one.line(), "hello");
  one.send("throw\nhello\n");
  EXPECT_EQ(one.line(), "(closed)");
  other.send("hello\n");
  EXPECT_EQ(other.line(), "hello");
}

}  // namespace
}  // namespace prehend::test
