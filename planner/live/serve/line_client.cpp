#include "planner/live/serve/line_client.h"

#include <utility>

#include "planner/live/serve/http_rules.h"
#include "planner/live/serve/token.h"
#include "planner/live/serve/utf8.h"

namespace prehend {

void LineClient::welcome() {
  if (listener_.needs_token) {
    limit_time();
  } else {
    join();
  }
}

void LineClient::use_bytes(std::string_view bytes) {
  splitter_.add(bytes, [this](std::string line, bool whole) {
    use_line(std::move(line), whole);
    return !is_finished();
  });
}

void LineClient::use_end() {
  // What waits for the client may wait for ever.
  limit_time();
  finish();
}

void LineClient::use_line(std::string line, bool whole) {
  if (std::exchange(is_first_, false)) {
    if (begins_as_http(line)) return end();
    if (listener_.needs_token) return use_token(line);
  }
  if (!whole) {
    refuse("longer than " + std::to_string(listener_.largest_line) + " bytes");
  } else if (!is_utf8(line)) {
    refuse("not UTF-8");
  } else {
    deliver(std::move(line));
  }
}

void LineClient::use_token(const std::string& shown) {
  if (same_secret(shown, token_)) {
    unlimit_time();
    join();
  } else {
    refuse("the token is wrong");
    finish();
  }
}

}  // namespace prehend
