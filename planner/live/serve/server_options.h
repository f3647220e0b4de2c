// What a Server serves, to whom, and its limits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "planner/live/serve/endpoint.h"
#include "planner/live/serve/http_rules.h"

namespace prehend {

// {"ok":false,"error":{"problem":"..."}}: how a program that talks JSON hears of a line that is
// none.
std::string json_error_line(const std::string& problem);

// Lines of text over TCP: each line that comes is a message, and each message that goes is a line.
struct LineListener {
  Endpoint* endpoint = nullptr;  // outlives the server
  std::uint16_t port = 0;        // 0: any free one
  // Bytes of a line, without its end (> 0). What is longer is refused and not kept.
  std::size_t largest_line = std::size_t{16} << 20U;
  // Whether a client's first line is one of the protocol. One that sends another is told so and
  // disconnected: it talks something else, such as a web page that makes a browser send HTTP, and
  // what follows may be chosen to look like a command. Needed.
  std::function<bool(const std::string& line)> is_request = {};
  // The line that says what was wrong with a line: "longer than 16777216 bytes", "not text in
  // UTF-8", "not a request of this protocol" or "the token is wrong". The client is disconnected
  // then, unless it is a later line that is too long.
  std::function<std::string(const std::string& problem)> refusal = json_error_line;
  // The first line of each client must be the token, alone; others are refused and end it. To be
  // set where other machines reach the address.
  bool needs_token = false;
};

// Pages and a WebSocket, both of which need the token.
struct HttpListener {
  Endpoint* endpoint = nullptr;  // outlives the server; of the WebSocket at kSocketPath
  std::uint16_t port = 0;        // 0: any free one
  Pages pages = {};
  // What the pages may do (Content-Security-Policy).
  std::string content_security_policy = "default-src 'none'; frame-ancestors 'none'";
  // Bytes of a message (> 0). A client that sends a larger one is disconnected.
  std::size_t largest_message = std::size_t{16} << 20U;
  // Names of this server besides localhost, 127.0.0.1, [::1] and `address`.
  std::vector<std::string> hosts = {};
};

struct ServerOptions {
  std::string address = "127.0.0.1";  // an IP address of this machine
  std::optional<HttpListener> http = {};
  std::vector<LineListener> lines = {};
  std::string token = {};  // letters, digits, "-" and "_"; empty: a random one
  // Bytes that may wait to be sent to one client (> 0). One that is further behind is disconnected.
  std::size_t largest_waiting = std::size_t{64} << 20U;
  // Connections of all kinds at a time (> 0). One too many is told so, and closed.
  std::size_t clients = 32;
  // Seconds (> 0) that a request for a page, a WebSocket's handshake or a token may take, and that
  // the last messages may take to a client that sends no more.
  double handshake_time = 10.0;
  // Seconds (> 0) without a sign of life, after which a WebSocket is closed. It is asked for one
  // after half of that.
  double idle_time = 300.0;
  int threads = 2;  // that serve all clients (> 0)
};

// Throws InputError for options that are out of their ranges, with the field.
void check_options(const ServerOptions& options);

// What every answer says to a browser, by the names of the headers: nothing is kept, guessed or put
// into another page.
std::vector<std::pair<std::string, std::string>> safety_headers(const HttpListener& listener);

// HttpRules::hosts of a server with these options.
std::vector<std::string> hosts_of(const ServerOptions& options);

}  // namespace prehend
