// The protocol written down for other programs and for people, made from the table of commands.
#pragma once

#include <string>

#include "planner/live/protocol/command.h"

namespace prehend {

// A JSON schema of the fields of a command alone, with all that it refers to.
ProtocolJson command_schema(const Command& command);

// docs/reference/protocol.schema.json: a JSON schema (draft 2020-12) of requests, replies and
// events.
std::string protocol_schema();

// The part of docs/reference/protocol.md that lists all commands with their fields.
std::string protocol_reference();

}  // namespace prehend
