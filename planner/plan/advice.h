// What a plan without a grasp says: how its candidates ended by rule, and what to try instead.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "sim/trial/outcome.h"

namespace prehend {

// What may help where no grasp was found. Each is given only where it applies; for the first six a
// few candidates were tried that way, and at least one held.
enum class Hint {
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

// All of them, in the order of the enum, which is also that of PlanResult::advice.
inline constexpr std::array<Hint, 9> kHints = {
    Hint::friction, Hint::soft_contacts, Hint::other_hand, Hint::tolerance, Hint::obstacle,
    Hint::arm,      Hint::candidates,    Hint::path,       Hint::unit};

// "friction", "soft_contacts", ...: as in files.
constexpr std::string_view hint_name(Hint hint) {
  constexpr std::array<std::string_view, kHints.size()> kNames = {
      "friction", "soft_contacts", "other_hand", "tolerance", "obstacle",
      "arm",      "candidates",    "path",       "unit"};
  return kNames[static_cast<std::size_t>(hint)];
}

// One hint, in words that name the option of the program or the field of the scene file.
struct Advice {
  Hint hint = Hint::friction;
  std::string words;
};

// How many candidates of one rule ended with each Outcome.
struct RuleCount {
  std::string rule;  // "box faces", "cylinder end", ...: see AimedGrasp::rule
  std::array<int, kOutcomes.size()> outcomes{};
};

}  // namespace prehend
