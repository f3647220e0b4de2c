#include "planner/live/serve/line_client.h"

#include <utility>

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
  if (listener_.needs_token && !std::exchange(shows_token_, true)) return use_token(line);
  const bool is_first = std::exchange(is_first_, false);
  if (!whole) {
    refuse("longer than " + std::to_string(listener_.largest_line) + " bytes", is_first);
  } else if (!is_plain_text(line)) {
    refuse("not text in UTF-8", true);
  } else if (is_first && !listener_.is_request(line)) {
    refuse("not a request of this protocol", true);
  } else {
    deliver(std::move(line));
  }
}

void LineClient::use_token(const std::string& shown) {
  if (same_secret(shown, token_)) {
    unlimit_time();
    join();
  } else {
    refuse("the token is wrong", true);
  }
}

void LineClient::refuse(const std::string& problem, bool for_good) {
  say(listener_.refusal(problem));
  if (!for_good) return;
  limit_time();
  finish();
}

}  // namespace prehend
