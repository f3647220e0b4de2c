// Carries messages between clients and an Endpoint: over WebSocket for pages in browsers, and as
// lines of text over TCP for other programs (docs/reference/serve.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "planner/live/serve/server_options.h"

namespace prehend {

// The ports that a server listens on.
struct ServerPorts {
  std::uint16_t http = 0;            // 0: none
  std::vector<std::uint16_t> lines;  // as ServerOptions::lines
};

// While it runs, each client has its calls of the endpoint one after the other: connect(),
// receive() for each message, disconnect(). Those of different clients run at once. They run on the
// threads that serve all clients, so they should return soon; an exception from one of them ends
// its client.
class Server {
 public:
  // Throws InputError for options that are out of their ranges.
  explicit Server(ServerOptions options);
  // Stops.
  ~Server();  // NOLINT(bugprone-exception-escape)
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // Opens all ports, and serves on threads of its own from now on. Once a server. Throws InputError
  // with the field ("http.port", "lines[0].port", "address") and its value for what cannot be
  // opened, such as a port that is taken.
  ServerPorts start();

  // Closes all connections at once, whatever they are at, and returns when every client was
  // disconnected from its endpoint: that takes as long as the call of an endpoint that still runs.
  // Not from such a call.
  void stop();

  const std::string& token() const;

  // Connections at the moment, those that have not shown their token among them.
  std::size_t connections() const;

 private:
  class Impl;
  std::unique_ptr<Impl> hub_;
};

}  // namespace prehend
