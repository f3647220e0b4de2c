// The one dial between speed and accuracy: settings that belong together, under a name.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "planner/plan/plan_options.h"
#include "sim/base/named_enum.h"

namespace prehend {

// How much work a plan does.
enum class Accuracy {
  draft,     // a first impression: half the trials and half the refinement, no volumes
  standard,  // the defaults of all options
  fine,      // four times the trials, more refinement, rounder friction cones
};

// The same word as the enumerator.
constexpr auto enum_names(Accuracy /*of*/) {
  return std::to_array<std::string_view>({"draft", "standard", "fine"});
}

// Options with the settings of this accuracy; all others have their defaults. Every accuracy has
// contacts at the same gap, proven free of penetration, and an epsilon that is certified for them.
PlanOptions plan_options(Accuracy accuracy);

}  // namespace prehend
