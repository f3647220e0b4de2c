// Which grasps are lifted, turned how, and how heavy the object is.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "sim/base/named_enum.h"

namespace prehend::bench {

// Where gravity pulls on an object that a hand with cups holds.
enum class HungAttitude {
  as_it_lies,  // along -z of the object's file
  worst,       // as PayloadMargin::worst
  off_cups,    // along the approach: away from the cups
  sideways,    // across the approach, as far as can be along the way from the cups to the centre of
               // mass, so that the weight shears and tilts
};

constexpr auto enum_names(HungAttitude /*of*/) {
  return std::to_array<std::string_view>({"as it lies", "worst", "away from the cups", "sideways"});
}

// `count` indices of `values`, or all: as evenly as can be from the smallest to the largest, both
// included, in ascending order of values, equal ones in theirs.
std::vector<std::size_t> spread_over(const std::vector<double>& values, std::size_t count);

// One of several lists, and which round of taking one from each it was taken in: its index there.
struct TakenItem {
  std::size_t list = 0;
  std::size_t item = 0;
};

// The first of each list, then the second of each that has one, until there are `count`, or all.
std::vector<TakenItem> in_turn(const std::vector<std::size_t>& sizes, std::size_t count);

// `count` factors, evenly spread on a logarithmic scale from low to high, both included (> 0), in
// an order in which neighbours are far apart.
std::vector<double> spread_factors(double low, double high, std::size_t count);

}  // namespace prehend::bench
