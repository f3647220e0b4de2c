// GraspIt!'s text protocol on a session (docs/reference/graspit-protocol.md): a line of words in,
// lines out.
#pragma once

#include <string>
#include <vector>

#include "planner/live/session.h"

namespace prehend {

// "Error: " and the problem: how clients hear of everything that is wrong.
std::string graspit_error_line(const std::string& problem);

// Whether a line begins with a command of the protocol.
bool is_graspit_command(const std::string& line);

// Carries out one line. Never throws InputError: what is refused gives one line,
// graspit_error_line.
std::vector<std::string> graspit_reply(Session& session, const std::string& line);

}  // namespace prehend
