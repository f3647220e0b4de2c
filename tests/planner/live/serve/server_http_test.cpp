#include <string>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "tests/support/echo_server.h"

namespace prehend::test {
namespace {

std::string get(const EchoServer& echo, const std::string& target, const std::string& more = "") {
  return "GET " + target + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(echo.ports.http) +
         "\r\n" + more + "\r\n";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(ServerHttp, ThePageComesWithWhatKeepsItSafe) {
  const EchoServer echo;
  const std::string answer = echo.answer(get(echo, "/?token=secret"));
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 OK\r\n")) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n<p>start</p>")) << answer;
  for (const char* line :
       {"Content-Type: text/html; charset=utf-8", "Content-Length: 12", "Cache-Control: no-store",
        "X-Content-Type-Options: nosniff", "Content-Security-Policy: default-src 'self'",
        "Referrer-Policy: no-referrer", "X-Frame-Options: DENY",
        "Cross-Origin-Resource-Policy: same-origin"}) {
    EXPECT_TRUE(contains(answer, "\r\n" + std::string(line) + "\r\n")) << line << " in " << answer;
  }
}

TEST(ServerHttp, WhatIsNotForTheAskerIsRefused) {
  const EchoServer echo;
  const std::string port = std::to_string(echo.ports.http);
  const auto status = [&](const std::string& request) { return echo.answer(request).substr(9, 3); };
  EXPECT_EQ(status(get(echo, "/?token=wrong")), "403");
  EXPECT_EQ(status(get(echo, "/")), "403");
  EXPECT_EQ(status(get(echo, "/other?token=secret")), "404");
  EXPECT_EQ(status(get(echo, "/../../etc/passwd?token=secret")), "404");
  EXPECT_EQ(status(get(echo, "/?token=secret", "Origin: http://evil.com\r\n")), "403");
  EXPECT_EQ(status("GET /?token=secret HTTP/1.1\r\nHost: evil.com:" + port + "\r\n\r\n"), "403");
  EXPECT_EQ(status("GET /?token=secret HTTP/1.0\r\n\r\n"), "403");
  const std::string posted = echo.answer("POST /?token=secret HTTP/1.1\r\nHost: localhost:" + port +
                                         "\r\nContent-Length: 5\r\n\r\nhello");
  EXPECT_TRUE(posted.starts_with("HTTP/1.1 405")) << posted;
}

TEST(ServerHttp, FieldsThatMayComeOnceOnlyMustNotComeTwice) {
  const EchoServer echo;
  const std::string port = std::to_string(echo.ports.http);
  const std::string own = "Origin: http://127.0.0.1:" + port + "\r\n";
  const std::string upgrade =
      "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
      "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  const auto status = [&](const std::string& target, const std::string& more) {
    SocketClient client = echo.http_client();
    client.send(get(echo, target, more));
    return client.bytes(12).substr(9);
  };
  EXPECT_EQ(status("/?token=secret", own), "200");
  EXPECT_EQ(status("/socket?token=secret", upgrade + own), "101");
  for (const std::string& target :
       {std::string("/?token=secret"), std::string("/socket?token=secret")}) {
    EXPECT_EQ(status(target, upgrade + own + own), "400") << target;
    EXPECT_EQ(status(target, upgrade + own + "origin: http://evil.com\r\n"), "400") << target;
    EXPECT_EQ(status(target, upgrade + "Origin: http://evil.com\r\n" + own), "400") << target;
    for (const char* field : {"Host: evil.com", "Sec-WebSocket-Version: 13", "Upgrade: websocket",
                              "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ=="}) {
      EXPECT_EQ(status(target, upgrade + std::string(field) + "\r\n"), "400") << field;
    }
  }
}

TEST(ServerHttp, HeadIsThePageWithoutItsBody) {
  const EchoServer echo;
  const std::string answer = echo.answer("HEAD /?token=secret HTTP/1.1\r\nHost: localhost:" +
                                         std::to_string(echo.ports.http) + "\r\n\r\n");
  EXPECT_TRUE(contains(answer, "Content-Length: 12\r\n")) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n")) << answer;
}

TEST(ServerHttp, GarbageIsRefusedAndOthersAreServed) {
  const EchoServer echo;
  EXPECT_TRUE(echo.answer("hello\r\n\r\n").starts_with("HTTP/1.1 400"));
  EXPECT_TRUE(echo.answer("GET / HTTP/9.9\r\n\r\n").starts_with("HTTP/1.1 400"));
  const std::string large = get(echo, "/?token=secret", "X: " + std::string(20000, 'x') + "\r\n");
  EXPECT_TRUE(echo.answer(large).starts_with("HTTP/1.1 431"));
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    std::string bytes;
    for (std::size_t k = random.index(300); k > 0; --k) {
      bytes += static_cast<char>(random.index(256));
    }
    SocketClient client = echo.http_client();
    client.send(bytes);
    client.end_sending();
    const std::string answer = client.rest();
    EXPECT_TRUE(answer.empty() || answer.starts_with("HTTP/1.1 400")) << answer;
  }
  EXPECT_TRUE(echo.answer(get(echo, "/?token=secret")).starts_with("HTTP/1.1 200"));
}

TEST(ServerHttp, HalfARequestMustNotTakeLong) {
  const EchoServer echo([](ServerOptions& options) { options.handshake_time = 0.05; });
  EXPECT_EQ(echo.answer("GET /?token=sec"), "");
  EXPECT_EQ(echo.answer(""), "");
}

TEST(ServerHttp, OneClientTooManyHearsThatTheServerIsBusy) {
  const EchoServer echo([](ServerOptions& options) { options.clients = 1; });
  SocketClient first = echo.line_client();
  first.send("here\n");
  EXPECT_EQ(first.line(), "here");
  EXPECT_TRUE(echo.answer("").starts_with("HTTP/1.1 503"));
}

TEST(ServerWebSocket, CarriesMessagesBothWaysInOrder) {
  EchoServer echo;
  WebSocketClient client = echo.web_socket();
  ASSERT_EQ(client.status(), "HTTP/1.1 101 Switching Protocols\r");
  // RFC 6455, 1.3: of the key that the client sends.
  EXPECT_TRUE(contains(client.header(), "Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo="));
  for (int i = 0; i < 100; ++i) {
    client.send_frame(WebSocketClient::kText, "message " + std::to_string(i));
  }
  for (int i = 0; i < 100; ++i) {
    const Frame frame = client.next_frame();
    EXPECT_EQ(frame.kind, WebSocketClient::kText);
    EXPECT_TRUE(frame.is_last);
    EXPECT_EQ(frame.payload, "message " + std::to_string(i));
  }
  echo.endpoint.clients().at(1).send(std::string(70000, 'e'));
  EXPECT_EQ(client.next_frame().payload, std::string(70000, 'e'));
}

TEST(ServerWebSocket, IsRefusedWithoutTheTokenAndToOtherPages) {
  EchoServer echo;
  const std::uint16_t port = echo.ports.http;
  const std::string own = "127.0.0.1:" + std::to_string(port);
  const std::string refused = "HTTP/1.1 403 Forbidden\r";
  EXPECT_EQ(WebSocketClient(port, "wrong").status(), refused);
  EXPECT_EQ(WebSocketClient(port, "").status(), refused);
  EXPECT_EQ(WebSocketClient(port, "secret", "evil.com", "").status(), refused);
  EXPECT_EQ(WebSocketClient(port, "secret", own, "Origin: http://evil.com\r\n").status(), refused);
  EXPECT_EQ(WebSocketClient(port, "secret", own, "Origin: null\r\n").status(), refused);
  EXPECT_EQ(WebSocketClient(port, "secret", own, "Origin: http://" + own + "\r\n").status(),
            "HTTP/1.1 101 Switching Protocols\r");
  EXPECT_TRUE(echo.answer(get(echo, "/socket?token=secret")).starts_with("HTTP/1.1 404"));
  echo.endpoint.wait_for_disconnected(1);
  EXPECT_EQ(echo.endpoint.clients().size(), 1U);
}

TEST(ServerWebSocket, MessagesMayComeInFragmentsWithPingsBetween) {
  const EchoServer echo;
  WebSocketClient client = echo.web_socket();
  client.send_frame(WebSocketClient::kText, "gr\xC3", false);
  client.send_frame(WebSocketClient::kPing, "are you there");
  client.send_frame(WebSocketClient::kMore, "\xBC", false);
  client.send_frame(WebSocketClient::kMore, "\xC3\x9F");
  const Frame pong = client.next_frame();
  EXPECT_EQ(pong.kind, WebSocketClient::kPong);
  EXPECT_EQ(pong.payload, "are you there");
  EXPECT_EQ(client.next_frame().payload, "gr\xC3\xBC\xC3\x9F");
  // A frame whose bytes come one by one.
  for (const char byte : WebSocketClient::frame(WebSocketClient::kText, "slow")) {
    client.socket().send({&byte, 1});
  }
  EXPECT_EQ(client.next_frame().payload, "slow");
}

TEST(ServerWebSocket, BinaryMessagesAreTakenWhereTheyAreText) {
  const EchoServer echo;
  WebSocketClient client = echo.web_socket();
  client.send_frame(WebSocketClient::kBinary, "text");
  client.send_frame(WebSocketClient::kBinary, "\xFF");
  EXPECT_EQ(client.next_frame().payload, "text");
  EXPECT_EQ(client.next_frame().payload, R"({"ok":false,"error":{"problem":"not UTF-8"}})");
}

// The last frame is a close with this code (RFC 6455, 7.4.1), or the connection is just closed.
void expect_closed_with(WebSocketClient& client, unsigned code) {
  const Frame frame = client.next_frame();
  if (frame.kind == -1) return;
  EXPECT_EQ(frame.kind, WebSocketClient::kClose);
  ASSERT_GE(frame.payload.size(), 2U);
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(frame.payload[i]); };
  EXPECT_EQ(byte(0) * 256U + byte(1), code);
}

TEST(ServerWebSocket, BrokenFramesEndTheConnection) {
  EchoServer echo;
  WebSocketClient large = echo.web_socket();
  large.send_frame(WebSocketClient::kText, std::string(EchoServer::kLargest, 'x'));
  EXPECT_EQ(large.next_frame().payload.size(), EchoServer::kLargest);
  large.send_frame(WebSocketClient::kText, std::string(EchoServer::kLargest + 1, 'x'));
  expect_closed_with(large, 1009);
  // Of which only the size has come: 2^62 bytes.
  WebSocketClient huge = echo.web_socket();
  huge.socket().send(std::string("\x81\xFF\x40\0\0\0\0\0\0\0\1\2\3\4", 14));
  expect_closed_with(huge, 1009);
  WebSocketClient many = echo.web_socket();
  for (int i = 0; i < 11; ++i) {
    many.send_frame(i == 0 ? WebSocketClient::kText : WebSocketClient::kMore,
                    std::string(EchoServer::kLargest / 10, 'x'), false);
  }
  expect_closed_with(many, 1009);
  WebSocketClient no_text = echo.web_socket();
  no_text.send_frame(WebSocketClient::kText, "\xFF\xFF");
  expect_closed_with(no_text, 1007);
  WebSocketClient unmasked = echo.web_socket();
  unmasked.socket().send("\x81\x02hi");
  expect_closed_with(unmasked, 1002);
  echo.endpoint.wait_for_disconnected(5);
  EXPECT_EQ(echo.endpoint.clients().at(1).received.size(), 1U);
}

TEST(ServerWebSocket, IsClosedWhenItsClientWantsThat) {
  EchoServer echo;
  WebSocketClient client = echo.web_socket();
  client.send_frame(WebSocketClient::kClose, "\x03\xE8");
  EXPECT_EQ(client.next_frame().kind, WebSocketClient::kClose);
  EXPECT_EQ(client.next_frame().kind, -1);
  echo.endpoint.wait_for_disconnected(1);
}

TEST(ServerWebSocket, IsAskedForASignOfLifeAndClosedWithoutOne) {
  EchoServer echo([](ServerOptions& options) { options.idle_time = 0.2; });
  WebSocketClient client = echo.web_socket();
  EXPECT_EQ(client.next_frame().kind, WebSocketClient::kPing);
  echo.endpoint.wait_for_disconnected(1);
}

TEST(ServerWebSocket, AClientThatNeverReadsIsDisconnectedAndStallsNobody) {
  EchoServer echo;
  WebSocketClient deaf = echo.web_socket();
  deaf.socket().read_little();
  deaf.send_frame(WebSocketClient::kText, "hello");
  deaf.next_frame();
  WebSocketClient other = echo.web_socket();
  const auto send = echo.endpoint.clients().at(1).send;
  for (int i = 0; i < 500; ++i) {
    send(std::string(65536, 'x'));
    other.send_frame(WebSocketClient::kText, "still there");
    ASSERT_EQ(other.next_frame().payload, "still there");
  }
  echo.endpoint.wait_for_disconnected(1);
  EXPECT_EQ(echo.endpoint.clients().at(1).disconnected, 1);
}

}  // namespace
}  // namespace prehend::test
