// How a step of a world ended.
#pragma once

#include <array>
#include <string_view>

#include "sim/base/named_enum.h"

namespace prehend {

// How a step ended.
enum class StepOutcome {
  moved,
  not_converged,  // the law of contact was not met to its tolerance; the bodies moved all the same
  blocked,        // no step however short was free of penetration; the bodies are where they were
  not_finite,     // velocities beyond all numbers; the bodies are where they were
};

// The name in files: the same word as the enumerator.
constexpr auto enum_names(StepOutcome /*of*/) {
  return std::to_array<std::string_view>({"moved", "not_converged", "blocked", "not_finite"});
}

}  // namespace prehend
