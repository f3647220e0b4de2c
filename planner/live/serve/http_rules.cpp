#include "planner/live/serve/http_rules.h"

#include <algorithm>
#include <cstddef>

#include "planner/live/serve/token.h"

namespace prehend {
namespace {

// Names of hosts mean the same in any case of their letters (RFC 3986, 3.2.2).
std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& letter : small) {
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  }
  return small;
}

bool is_this_server(std::string_view host, const HttpRules& rules) {
  const std::string asked = in_small_letters(host);
  return std::any_of(rules.hosts.begin(), rules.hosts.end(), [&](const std::string& own) {
    return asked == own + ":" + std::to_string(rules.port) || (rules.port == 80 && asked == own);
  });
}

bool is_own_page(std::string_view origin, const HttpRules& rules) {
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && is_this_server(origin.substr(kScheme.size()), rules);
}

// The value of the first `token` in the query; empty where there is none.
std::string_view token_in(std::string_view query) {
  constexpr std::string_view kName = "token=";
  while (!query.empty()) {
    const std::size_t end = query.find('&');
    const std::string_view field = query.substr(0, end);
    if (field.starts_with(kName)) return field.substr(kName.size());
    query.remove_prefix(end == std::string_view::npos ? query.size() : end + 1);
  }
  return {};
}

}  // namespace

HttpAnswer answer_to(const HttpRequest& request, const HttpRules& rules, const Pages& pages) {
  if (request.repeats) return {400};
  if (!is_this_server(request.host, rules)) return {403};
  if (request.origin && !is_own_page(*request.origin, rules)) return {403};
  const std::size_t query = request.target.find('?');
  const std::string_view path = request.target.substr(0, query);
  const bool is_socket = path == kSocketPath && request.is_upgrade;
  const auto page = pages.find(path);
  if (!is_socket && page == pages.end()) return {404};
  const bool may_ask = request.method == "GET" || (request.method == "HEAD" && !is_socket);
  if (!may_ask) return {405};
  const std::string_view shown =
      query == std::string_view::npos ? std::string_view() : request.target.substr(query + 1);
  if (rules.token.empty() || !same_secret(token_in(shown), rules.token)) return {403};
  if (is_socket) return {.status = 101, .upgrade = true};
  return {.status = 200, .page = &page->second};
}

}  // namespace prehend
