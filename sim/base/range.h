// The values that a number may have.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "sim/base/formatted.h"

namespace prehend {

// An interval, with its upper end and, unless without_lower, its lower end. NaN is in none.
struct Range {
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  bool without_lower = false;  // above `lower`, not at it

  bool contains(double value) const {
    return (without_lower ? value > lower : value >= lower) && value <= upper;
  }

  // "must be at least 1 and at most 3", "must be above 0".
  std::string words() const {
    std::string text = formatted(without_lower ? "must be above %g" : "must be at least %g", lower);
    if (std::isfinite(upper)) text += formatted(" and at most %g", upper);
    return text;
  }
};

inline constexpr Range kAnyNumber{.lower = -std::numeric_limits<double>::infinity()};
inline constexpr Range kAtLeast0{};
inline constexpr Range kAtLeast1{.lower = 1.0};
inline constexpr Range kAbove0{.without_lower = true};
// Fractions in [0, 1): the upper end is the largest double below 1.
inline constexpr Range kPart{.upper = 0.9999999999999999};

}  // namespace prehend
