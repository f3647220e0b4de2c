// Visits every setting of a struct of options by name and range, for files of settings.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

#include "sim/base/range.h"

namespace prehend {

// Each struct of options that influences a result has a function beside it that visits its fields:
//
//   template <SettingsOf<SomeOptions> Options, typename Visit>
//   void for_each_setting(Options& options, const Visit& visit) {
//     auto& [angle, steps, inner] = options;   // does not compile while a field is missing
//     visit("angle", angle, kAbove0);          // a number has a range (range.h), or may be any
//     visit("steps", steps, kAtLeast1);
//     visit("inner", inner);                   // has settings of its own: visit_settings goes on
//   }
//
// It visits all fields except seeds, which derive from the seed of the run (random.h). SettingsOf
// accepts the struct both const (for writing a file) and mutable (for reading one).
template <typename T, typename Options>
concept SettingsOf = std::same_as<std::remove_const_t<T>, Options>;

namespace detail {
// A visitor that accepts every value; for the concept below only.
struct AnySetting {
  void operator()(std::string_view, auto&, const Range& = kAnyNumber) const {}
};
}  // namespace detail

// True for structs of options with a function for_each_setting.
template <typename T>
concept HasSettings = requires(T& options) {
  for_each_setting(options, detail::AnySetting{});
};

// Calls leaf(name, value, range) for every value in `options` and, recursively, in nested structs
// of options. The name of a nested value is OUTER_INNER, or INNER alone where the outer struct
// visits the nested one with an empty name.
template <HasSettings Options, typename Leaf>
void visit_settings(Options& options, const Leaf& leaf, const std::string& prefix = "") {
  const auto visit = [&](std::string_view name, auto& value, const Range& range = kAnyNumber) {
    const std::string whole = prefix + std::string(name);
    if constexpr (HasSettings<std::remove_reference_t<decltype(value)>>) {
      visit_settings(value, leaf, name.empty() ? prefix : whole + "_");
    } else {
      leaf(whole, value, range);
    }
  };
  for_each_setting(options, visit);
}

// The range of one number among the settings of an Options; any number for one that is not visited,
// such as a seed.
template <HasSettings Options, typename Number>
Range range_of(Number Options::*member) {
  Options options;
  Range found = kAnyNumber;
  for_each_setting(options, [&](std::string_view, auto& value, const Range& range = kAnyNumber) {
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(value)>, Number>) {
      if (&value == &(options.*member)) found = range;
    }
  });
  return found;
}

}  // namespace prehend
