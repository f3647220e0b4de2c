#include "planner/live/serve/server.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/echo_server.h"
#include "tests/support/refusal_of.h"

namespace prehend::test {
namespace {

ServerOptions changed(EchoEndpoint& endpoint, const std::function<void(ServerOptions&)>& change) {
  ServerOptions options = EchoServer::options_for(endpoint);
  change(options);
  return options;
}

TEST(Server, ATakenPortIsRefusedByItsField) {
  const EchoServer first;
  EchoEndpoint endpoint;
  const std::uint16_t taken = first.ports.lines.at(0);
  Server lines(changed(endpoint, [&](ServerOptions& options) { options.lines[0].port = taken; }));
  const InputError of_lines = refusal_of([&] { lines.start(); });
  EXPECT_EQ(of_lines.field(), "lines[0].port");
  EXPECT_EQ(of_lines.problem(), "cannot be opened: Address already in use");
  EXPECT_EQ(of_lines.value(), std::to_string(taken));
  Server http(changed(endpoint, [&](ServerOptions& options) { options.http->port = taken; }));
  EXPECT_EQ(refusal_of([&] { http.start(); }).field(), "http.port");
  // Of the documentation (RFC 5737): no machine has it.
  Server elsewhere(changed(endpoint, [&](ServerOptions& options) {
    options.address = "192.0.2.1";
    options.lines[0].needs_token = true;
  }));
  const InputError of_address = refusal_of([&] { elsewhere.start(); });
  EXPECT_EQ(of_address.field(), "address");
  EXPECT_EQ(of_address.value(), "192.0.2.1");
}

TEST(Server, OptionsOutOfTheirRangesAreRefused) {
  EchoEndpoint endpoint;
  const auto field_of = [&](const std::function<void(ServerOptions&)>& change) {
    return refusal_of([&] { const Server server(changed(endpoint, change)); }).field();
  };
  EXPECT_EQ(field_of([](ServerOptions& o) { o.address = "localhost"; }), "address");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.address = "0.0.0.0"; }), "lines[0].needs_token");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.address = "::"; }), "lines[0].needs_token");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.token = "a b"; }), "token");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.lines[0].endpoint = nullptr; }), "lines[0].endpoint");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.lines[0].largest_line = 0; }),
            "lines[0].largest_line");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.lines[0].is_request = nullptr; }),
            "lines[0].is_request");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.http->endpoint = nullptr; }), "http.endpoint");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.http->largest_message = 0; }),
            "http.largest_message");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.largest_waiting = 0; }), "largest_waiting");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.clients = 0; }), "clients");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.handshake_time = 0.0; }), "handshake_time");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.idle_time = -1.0; }), "idle_time");
  EXPECT_EQ(field_of([](ServerOptions& o) { o.threads = 0; }), "threads");
}

TEST(Server, MakesATokenOfItsOwn) {
  EchoEndpoint endpoint;
  const auto without = [](ServerOptions& options) { options.token.clear(); };
  const Server one(changed(endpoint, without));
  const Server other(changed(endpoint, without));
  EXPECT_EQ(one.token().size(), 32U);
  EXPECT_NE(one.token(), other.token());
}

TEST(Server, ServesWhatItIsAskedToOnly) {
  EchoEndpoint endpoint;
  Server server(changed(endpoint, [](ServerOptions& options) { options.http.reset(); }));
  const ServerPorts ports = server.start();
  EXPECT_EQ(ports.http, 0);
  EXPECT_EQ(ports.lines.size(), 1U);
}

TEST(Server, StopsWhateverItsClientsAreAt) {
  EchoServer echo;
  SocketClient idle = echo.line_client();
  SocketClient half_line = echo.line_client();
  half_line.send("hal");
  SocketClient half_request = echo.http_client();
  half_request.send("GET / HT");
  SocketClient silent = echo.http_client();
  WebSocketClient half_frame = echo.web_socket();
  half_frame.socket().send("\x81");
  WebSocketClient deaf = echo.web_socket();
  deaf.send_frame(WebSocketClient::kText, "hello");
  deaf.next_frame();
  echo.endpoint.wait_until([](const auto& clients) { return clients.size() == 4; });
  for (const auto& [id, client] : echo.endpoint.clients()) {
    client.send(std::string(900000, 'x'));
  }
  echo.server.stop();
  EXPECT_EQ(echo.server.connections(), 0U);
  EXPECT_EQ(half_request.rest(), "");
  EXPECT_EQ(silent.rest(), "");
  for (const auto& [id, client] : echo.endpoint.clients()) {
    EXPECT_EQ(client.disconnected, 1) << id;
    client.send("too late");
  }
  EXPECT_FALSE(echo.line_client().is_connected());
  echo.server.stop();
}

TEST(Server, StopsWhileClientsComeAndTalk) {
  for (int round = 0; round < 20; ++round) {
    EchoServer echo;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        for (int k = 0; k < 20; ++k) {
          SocketClient client(echo.ports.lines[0]);
          if (!client.send("one\ntwo\n")) return;
          client.line();
        }
      });
    }
    echo.endpoint.wait_until(
        [&](const auto& clients) { return clients.size() > static_cast<std::size_t>(round); });
    echo.server.stop();
    for (std::thread& thread : threads) thread.join();
    for (const auto& [id, client] : echo.endpoint.clients()) EXPECT_EQ(client.disconnected, 1);
  }
}

TEST(Server, APortIsFreeAgainAfterItsServer) {
  auto first = std::make_unique<EchoServer>();
  const std::uint16_t port = first->ports.lines.at(0);
  SocketClient client = first->line_client();
  client.send("hello\n");
  EXPECT_EQ(client.line(), "hello");
  first.reset();
  const EchoServer second([&](ServerOptions& options) { options.lines[0].port = port; });
  EXPECT_EQ(second.ports.lines.at(0), port);
}

TEST(Server, IsDestroyedWithoutHavingStarted) {
  EchoEndpoint endpoint;
  Server server(EchoServer::options_for(endpoint));
  server.stop();
}

}  // namespace
}  // namespace prehend::test
