// Clients that talk GraspIt!'s text protocol, on the session of all others.
#pragma once

#include <functional>
#include <string>

#include "planner/live/serve/endpoint.h"

namespace prehend {

// Hands each line on as the command `graspit` of the protocol, and its reply back as lines. So
// lines of these clients and messages of others are carried out one after the other, recorded and
// replayed alike. A message is a line, and so is its reply: several of them with line breaks
// between; none where a command replies nothing. Events are not passed on.
class GraspitEndpoint : public Endpoint {
 public:
  // `session` outlives it.
  explicit GraspitEndpoint(Endpoint& session) : session_(session) {}

  ClientId connect(std::function<void(std::string)> send) override;
  void receive(ClientId client, std::string message) override;
  void disconnect(ClientId client) override { session_.disconnect(client); }

 private:
  Endpoint& session_;
};

}  // namespace prehend
