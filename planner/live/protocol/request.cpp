#include "planner/live/protocol/request.h"

#include <exception>
#include <new>
#include <system_error>
#include <utility>

namespace prehend {
namespace {

// What errors call the message where a file's name would stand.
constexpr const char* kMessage = "message";

InputError unknown_command(const std::string& name) {
  return InputError({.field = "command", .problem = "unknown, hello lists them", .value = name});
}

// The id as JSON text, which comes back as it is.
std::string read_id(const JsonField& field) {
  const std::string id = field.json();
  const nlohmann::json value = nlohmann::json::parse(id);
  if (!value.is_number_integer() && !value.is_string()) field.fail("must be an integer or a text");
  return id;
}

void read_parts(const JsonField& root, Request& request) {
  if (!root.is_object()) root.fail("must be an object");
  if (root.has("id")) request.id = read_id(root["id"]);
  const std::string name = root["command"].text();
  const Command* command = find_command(name);
  if (command == nullptr) throw unknown_command(name);
  check_fields(*command, root);
  request.command = name;
}

ProtocolJson error_json(const InputError& error) {
  // The fault of a file that the message names is told with the file; the message has no name.
  const bool elsewhere = !error.file().empty() && error.file() != kMessage;
  const std::string problem = elsewhere ? error.file() + ": " + error.problem() : error.problem();
  return {{"field", error.field()}, {"problem", on_one_line(problem)}, {"value", error.value()}};
}

ProtocolJson plain_error(const std::string& problem) {
  return {{"field", ""}, {"problem", on_one_line(problem)}, {"value", ""}};
}

ProtocolJson refusal(const Request& request, ProtocolJson error) {
  return {{"id", ProtocolJson::parse(request.id)}, {"ok", false}, {"error", std::move(error)}};
}

}  // namespace

std::string message_text(const ProtocolJson& json) {
  return json.dump(-1, ' ', false, ProtocolJson::error_handler_t::replace);
}

bool is_request(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string::npos && text[begin] == '{' && nlohmann::json::accept(text);
}

Request read_request(const std::string& message) {
  Request request;
  try {
    require(message.size() <= kLongestMessage,
            {.field = kMessage,
             .problem = "longer than " + std::to_string(kLongestMessage) + " bytes",
             .value = std::to_string(message.size())});
    request.json = std::make_shared<const JsonFile>(kMessage, message);
    read_parts(request.json->root(), request);
  } catch (const InputError& error) {
    request.error = error;
  } catch (const std::bad_alloc&) {
    request.error = InputError({.field = kMessage, .problem = "out of memory"});
  }
  return request;
}

std::string reply_to(const Request& request, const CommandScope& scope) {
  try {
    if (request.error) throw InputError(*request.error);
    const Command& command = *find_command(request.command);
    ProtocolJson result = command.run(scope, request.json->root());
    return message_text(
        {{"id", ProtocolJson::parse(request.id)}, {"ok", true}, {"result", std::move(result)}});
  } catch (const InputError& error) {
    return message_text(refusal(request, error_json(error)));
  } catch (const std::bad_alloc&) {
    return message_text(refusal(request, plain_error("out of memory")));
  } catch (const std::system_error& error) {  // of a file or a thread
    return message_text(refusal(request, plain_error(error.what())));
  } catch (const std::exception& error) {
    return message_text(
        refusal(request, plain_error(std::string("internal error: ") + error.what())));
  }
}

}  // namespace prehend
