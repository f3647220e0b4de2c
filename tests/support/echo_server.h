// A server in front of an endpoint that answers with what it hears.
#pragma once

#include <string>
#include <utility>

#include "planner/live/serve/server.h"
#include "tests/support/echo_endpoint.h"
#include "tests/support/socket_client.h"
#include "tests/support/web_socket_client.h"

namespace prehend::test {

// One of lines and one of HTTP, on free ports. Lines that begin with "?" are none of its protocol.
struct EchoServer {
  static constexpr std::size_t kLargest = 100000;

  static ServerOptions options_for(Endpoint& endpoint) {
    ServerOptions options;
    options.http.emplace();
    options.http->endpoint = &endpoint;
    options.http->largest_message = kLargest;
    options.http->pages = {{"/", {"text/html; charset=utf-8", "<p>start</p>"}}};
    options.http->content_security_policy = "default-src 'self'";
    options.lines.emplace_back();
    options.lines[0].endpoint = &endpoint;
    options.lines[0].largest_line = kLargest;
    options.lines[0].is_request = [](const std::string& line) { return !line.starts_with('?'); };
    options.token = "secret";
    options.largest_waiting = std::size_t{1} << 20U;
    return options;
  }

  // `change` gets the options before the server does.
  template <typename Change>
  explicit EchoServer(Change change)
      : server([&] {
          ServerOptions options = options_for(endpoint);
          change(options);
          return options;
        }()),
        ports(server.start()) {}
  EchoServer() : EchoServer([](ServerOptions&) {}) {}

  SocketClient line_client() const { return SocketClient(ports.lines.at(0)); }
  SocketClient http_client() const { return SocketClient(ports.http); }
  WebSocketClient web_socket() const { return {ports.http, "secret"}; }

  // What the server answers to these bytes, until it closes the connection.
  std::string answer(const std::string& bytes) const {
    SocketClient client = http_client();
    client.send(bytes);
    return client.rest();
  }

  EchoEndpoint endpoint;
  Server server;
  ServerPorts ports;
};

}  // namespace prehend::test
