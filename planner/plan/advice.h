// What a plan without a grasp says: how its candidates ended by rule, and what to try instead.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sim/base/named_enum.h"
#include "sim/trial/outcome.h"

namespace prehend {

// What may help where no grasp was found. Each is given only where it applies; for all but
// the last three a few candidates were tried that way, and at least one held.
enum class Hint {
  approach,       // other directions of approach than the options allow
  keep_out,       // the parts of the object that hands must keep out of
  friction,       // rougher surfaces
  soft_contacts,  // rubber as soft fingers instead of hard points
  other_hand,     // another hand of the library
  tolerance,      // primitives that follow the object more closely
  obstacle,       // the obstacle that ended most trials out of the way
  arm,            // the arm elsewhere: the hand alone would hold the object
  candidates,     // all candidates instead of a selection
  path,           // another search for paths or another start
  unit,           // another unit of the mesh file
};

// As in files. Advice stands in this order in PlanResult::advice.
constexpr auto enum_names(Hint /*of*/) {
  return std::to_array<std::string_view>({"approach", "keep_out", "friction", "soft_contacts",
                                          "other_hand", "tolerance", "obstacle", "arm",
                                          "candidates", "path", "unit"});
}

// One hint, in words that name the option of the program or the field of the scene file.
struct Advice {
  Hint hint = Hint::friction;
  std::string words;
};

// How many candidates of one rule ended with each Outcome.
struct RuleCount {
  std::string rule;  // "box faces", "cylinder end", ...: see AimedGrasp::rule
  EnumArray<Outcome, int> outcomes;
};

}  // namespace prehend
