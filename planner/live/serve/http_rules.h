// Who may have what over HTTP: the rules, without a network.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace prehend {

// What a browser gets for a path.
struct Page {
  std::string content_type;  // such as "text/html; charset=utf-8"
  std::string body;
};

// By path, such as "/".
using Pages = std::map<std::string, Page, std::less<>>;

struct HttpRules {
  std::string token;
  // How this server may be called, without the port: names and addresses, in small letters.
  std::vector<std::string> hosts;
  std::uint16_t port = 0;
};

// What matters of a request.
struct HttpRequest {
  std::string_view method;
  std::string_view target;                 // path and query
  std::string_view host;                   // empty where there is none
  std::optional<std::string_view> origin;  // the page that asks, where a browser says so
  bool is_upgrade = false;                 // to a WebSocket
  bool repeats = false;                    // a header field that may come once only came twice
};

struct HttpAnswer {
  int status = 404;
  const Page* page = nullptr;  // with status 200; it belongs to the pages
  bool upgrade = false;        // accept the WebSocket, in place of any answer
};

// Path of the WebSocket.
inline constexpr std::string_view kSocketPath = "/socket";

// The answer to a request:
//   400  a header field came twice of which only one can be meant
//   403  its Host is not this server. Another web page can have its own name lead to this address
//        (DNS rebinding), but cannot make a browser say another name than that
//   403  its Origin is another page than those of this server
//   404  nothing has this path; nothing is read from disk
//   405  neither GET nor HEAD
//   403  without "token=TOKEN" in the query
//   200, or the upgrade, otherwise.
HttpAnswer answer_to(const HttpRequest& request, const HttpRules& rules, const Pages& pages);

}  // namespace prehend
