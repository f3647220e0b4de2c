#include "planner/live/serve/server_options.h"

#include <algorithm>
#include <arpa/inet.h>
#include <netinet/in.h>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

enum class Reach { none, this_machine, others };

// Who reaches an address; `none` where the text is not one.
Reach reach_of(const std::string& address) {
  in_addr four{};
  if (::inet_pton(AF_INET, address.c_str(), &four) == 1) {
    const bool is_loopback = (ntohl(four.s_addr) >> 24U) == 127U;
    return is_loopback ? Reach::this_machine : Reach::others;
  }
  in6_addr six{};
  if (::inet_pton(AF_INET6, address.c_str(), &six) != 1) return Reach::none;
  return IN6_IS_ADDR_LOOPBACK(&six) ? Reach::this_machine : Reach::others;
}

bool is_plain(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '-' || letter == '_';
}

void check_positive(const std::string& field, double value) {
  // A year: what is longer may not fit into a clock's numbers.
  constexpr double kLongest = 366.0 * 24.0 * 3600.0;
  require(value > 0.0 && value <= kLongest, {.field = field,
                                             .problem = "must be above 0, and a year at most",
                                             .value = std::to_string(value)});
}

void check_size(const std::string& field, std::size_t value) {
  require(value > 0, {.field = field, .problem = "must be above 0", .value = "0"});
}

void check_endpoint(const std::string& field, const Endpoint* endpoint) {
  require(endpoint != nullptr, {.field = field, .problem = "is missing"});
}

}  // namespace

std::string json_error_line(const std::string& problem) {
  return R"({"ok":false,"error":{"problem":")" + problem + R"("}})";
}

void check_options(const ServerOptions& options) {
  const Reach reach = reach_of(options.address);
  require(reach != Reach::none,
          {.field = "address", .problem = "must be an IP address", .value = options.address});
  require(std::all_of(options.token.begin(), options.token.end(), is_plain),
          {.field = "token", .problem = "may have letters, digits, - and _ only"});
  if (options.http) {
    check_endpoint("http.endpoint", options.http->endpoint);
    check_size("http.largest_message", options.http->largest_message);
  }
  for (std::size_t i = 0; i < options.lines.size(); ++i) {
    const LineListener& listener = options.lines[i];
    const std::string name = "lines[" + std::to_string(i) + "].";
    check_endpoint(name + "endpoint", listener.endpoint);
    check_size(name + "largest_line", listener.largest_line);
    require(listener.is_request != nullptr,
            {.field = name + "is_request", .problem = "is missing"});
    require(listener.needs_token || reach == Reach::this_machine,
            {.field = name + "needs_token",
             .problem = "must be set where other machines reach the address",
             .value = options.address});
  }
  check_size("largest_waiting", options.largest_waiting);
  check_size("clients", options.clients);
  check_positive("handshake_time", options.handshake_time);
  check_positive("idle_time", options.idle_time);
  require(
      options.threads > 0,
      {.field = "threads", .problem = "must be above 0", .value = std::to_string(options.threads)});
}

std::vector<std::pair<std::string, std::string>> safety_headers(const HttpListener& listener) {
  return {{"Cache-Control", "no-store"},
          {"X-Content-Type-Options", "nosniff"},
          {"Content-Security-Policy", listener.content_security_policy},
          // The address of the page has the token in it.
          {"Referrer-Policy", "no-referrer"},
          {"X-Frame-Options", "DENY"},
          {"Cross-Origin-Opener-Policy", "same-origin"},
          {"Cross-Origin-Resource-Policy", "same-origin"}};
}

std::vector<std::string> hosts_of(const ServerOptions& options) {
  std::vector<std::string> hosts = {"localhost", "127.0.0.1", "[::1]"};
  const bool is_six = options.address.find(':') != std::string::npos;
  hosts.push_back(is_six ? "[" + options.address + "]" : options.address);
  if (options.http) {
    hosts.insert(hosts.end(), options.http->hosts.begin(), options.http->hosts.end());
  }
  return hosts;
}

}  // namespace prehend
