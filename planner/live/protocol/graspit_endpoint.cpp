#include "planner/live/protocol/graspit_endpoint.h"

#include <utility>

#include "planner/live/protocol/graspit_text.h"
#include "planner/live/protocol/request.h"

namespace prehend {
namespace {

// What the client is sent for a message of the session; empty: nothing.
std::string lines_of(const std::string& message) {
  const nlohmann::json json = nlohmann::json::parse(message);
  if (json.contains("event")) return {};
  if (json["ok"] != true) {
    return graspit_error_line(json["error"]["problem"].get<std::string>());
  }
  std::string text;
  for (const nlohmann::json& line : json["result"]["lines"]) {
    text += (text.empty() ? "" : "\n") + line.get<std::string>();
  }
  return text;
}

}  // namespace

ClientId GraspitEndpoint::connect(std::function<void(std::string)> send) {
  return session_.connect([send = std::move(send)](const std::string& message) {
    std::string text = lines_of(message);
    if (!text.empty()) send(std::move(text));
  });
}

void GraspitEndpoint::receive(ClientId client, std::string message) {
  session_.receive(client, message_text({{"command", "graspit"}, {"line", std::move(message)}}));
}

}  // namespace prehend
