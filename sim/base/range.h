// The values that a number may have.
#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace prehend {

// An interval of finite numbers, with its upper end and, unless without_lower, its lower end. NaN
// is in none.
struct Range {
  double lower = 0.0;
  double upper = std::numeric_limits<double>::infinity();
  bool without_lower = false;  // above `lower`, not at it
  bool with_infinity = false;  // where there is no upper end

  bool contains(double value) const {
    return (std::isfinite(value) || with_infinity) &&
           (without_lower ? value > lower : value >= lower) && value <= upper;
  }

  // "must be at least 1 and at most 3", "must be above 0", "must be a number".
  std::string words() const;

  // As an interval: "[1, 3]", "(0, 1]", "> 0", ">= 1"; "" for any number.
  std::string interval() const;
};

inline constexpr Range kAnyNumber{.lower = -std::numeric_limits<double>::infinity()};
inline constexpr Range kAtLeast0{};
inline constexpr Range kAtLeast1{.lower = 1.0};
inline constexpr Range kAbove0{.without_lower = true};
inline constexpr Range kFraction{.upper = 1.0};
inline constexpr Range kFractionAbove0{.upper = 1.0, .without_lower = true};
// Edges of a pyramid that stands for a friction cone.
inline constexpr Range kConeEdges{.lower = 3.0, .upper = 1024.0};

}  // namespace prehend
