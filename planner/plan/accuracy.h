// The one dial between speed and accuracy: settings that belong together, under a name.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "planner/plan/plan_options.h"

namespace prehend {

// How much work a plan does.
enum class Accuracy {
  draft,     // a first impression: hands close once, nothing is refined, no volumes
  standard,  // the defaults of all options
  fine,      // four times the trials, more back-offs and refinement, rounder friction cones
};

inline constexpr std::array<Accuracy, 3> kAccuracies = {Accuracy::draft, Accuracy::standard,
                                                        Accuracy::fine};

// The same word as the enumerator.
constexpr std::string_view accuracy_name(Accuracy accuracy) {
  constexpr std::array<std::string_view, kAccuracies.size()> kNames = {"draft", "standard", "fine"};
  return kNames[static_cast<std::size_t>(accuracy)];
}

// The accuracy with this name; nothing for any other word.
std::optional<Accuracy> accuracy_named(std::string_view name);

// Options with the settings of this accuracy; all others have their defaults. Every accuracy has
// contacts at the same gap, proven free of penetration, and an epsilon that is certified for them.
PlanOptions plan_options(Accuracy accuracy);

}  // namespace prehend
