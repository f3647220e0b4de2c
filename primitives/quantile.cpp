#include "primitives/quantile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace prehend {
namespace {

// Near either end of the order so few places are found in one pass, which keeps the values seen so
// far that lie farthest out. Their list is rarely changed, so that its branch costs little.
constexpr std::size_t kFewPlaces = 4;

template <class Before>
double among_the_first(std::span<const double> values, std::size_t place, const Before& before) {
  std::array<double, kFewPlaces> first{};
  std::size_t count = 0;
  for (const double value : values) {
    if (count > place && !before(value, first[place])) continue;
    std::size_t at = count > place ? place : count++;
    for (; at > 0 && before(value, first[at - 1]); --at) first[at] = first[at - 1];
    first[at] = value;
  }
  return first[place];
}

// Moves the values for which `belongs` to the front and returns how many they are. The swap is
// carried out for every value: a branch would be taken at random, and its mispredictions would be
// most of the time.
template <class Belongs>
std::size_t move_to_front(std::span<double> values, const Belongs& belongs) {
  std::size_t count = 0;
  for (double& value : values) {
    const double moved = value;
    value = values[count];
    values[count] = moved;
    count += belongs(moved) ? 1U : 0U;
  }
  return count;
}

double middle_of(double a, double b, double c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

}  // namespace

// Quickselect (Hoare 1961). Values that make it slow, which only a contrived order does, are left
// to the standard library after some rounds.
double value_at_place(std::span<double> values, std::size_t place) {
  constexpr int kRounds = 40;
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t size = values.size();
    if (place < kFewPlaces) {
      return among_the_first(values, place, [](double a, double b) { return a < b; });
    }
    if (size - 1 - place < kFewPlaces) {
      return among_the_first(values, size - 1 - place, [](double a, double b) { return a > b; });
    }
    const double pivot = middle_of(values.front(), values[size / 2], values.back());
    std::size_t split = move_to_front(values, [pivot](double v) { return v < pivot; });
    if (place < split) {
      values = values.first(split);
      continue;
    }
    // Nothing below the pivot: it is the least, and those equal to it need to be passed over.
    if (split == 0) {
      split = move_to_front(values, [pivot](double v) { return v <= pivot; });
      if (place < split || split == 0) return pivot;
    }
    values = values.subspan(split);
    place -= split;
  }
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::size_t quantile_place(std::size_t count, double q) {
  return static_cast<std::size_t>(std::lround(q * static_cast<double>(count - 1)));
}

double quantile(std::span<double> values, double q) {
  return value_at_place(values, quantile_place(values.size(), q));
}

}  // namespace prehend
