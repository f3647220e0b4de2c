// Messages of clients, and the replies to them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "planner/live/protocol/command.h"
#include "sim/base/input_error.h"

namespace prehend {

// Longer messages are refused without being looked at [bytes]: room for a mesh of some 500,000
// triangles.
inline constexpr std::size_t kLongestMessage = std::size_t{64} << 20;

// A message as far as it could be understood.
struct Request {
  std::string id = "null";               // JSON text of an integer or a text; null: none was given
  std::string command;                   // empty where there is an error
  std::shared_ptr<const JsonFile> json;  // null where the message is no JSON
  std::optional<InputError> error;       // why it cannot be carried out
};

// Whether a text is a JSON object, as every request is.
bool is_request(const std::string& text);

// Never throws InputError: what is wrong with the message stands in Request::error.
Request read_request(const std::string& message);

// Carries out the request and makes the reply, one JSON text in one line. Everything that the
// command throws becomes an error reply.
std::string reply_to(const Request& request, const CommandScope& scope);

// The text of a message in one line; what is not UTF-8 is U+FFFD.
std::string message_text(const ProtocolJson& json);

}  // namespace prehend
