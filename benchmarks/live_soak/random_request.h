// Requests of clients that try everything, made from the protocol's own table of commands.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "planner/live/protocol/command.h"
#include "sim/base/random.h"

namespace prehend::live_soak {

using Json = nlohmann::json;

// The names that requests choose from, as they are at a moment.
struct KnownNames {  // NOLINT(bugprone-exception-escape): moving JSON throws nothing
  std::vector<std::string> hands;
  std::vector<std::string> platforms;
  std::vector<std::string> scenes;
  std::vector<std::string> generators;
  Json state;  // the last that was heard; null at first
};

// What `hello` tells, with scenes and platforms that a thousand requests are not held up by.
KnownNames names_of(const Json& hello);

// A request of any command of the protocol, with fields of the types that the table says. Most are
// sound; of the others a field is missing, too many, of another type or out of range. The same
// random numbers and names give the same request.
Json random_request(Random& random, const KnownNames& names);
// A sound one that changes the session, if it is carried out, by one step of undo.
Json random_change(Random& random, const KnownNames& names);

// A line that is no request, but text: cut, deep, or of wrong types.
std::string random_nonsense(Random& random, const KnownNames& names);

}  // namespace prehend::live_soak
