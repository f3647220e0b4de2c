// Settings: the fields of the structs of options, each declared once with its name, range, unit and
// meaning. Files of settings, the checks of callers' options, the classes in Python and the tables
// of the documents are made from these declarations (visit_settings.h).
#pragma once

#include <concepts>
#include <string_view>
#include <type_traits>

#include "sim/base/range.h"

namespace prehend {

// A struct of options has a name for callers outside C++, one sentence about it, and a function
// beside it that visits its fields:
//
//   struct SomeOptions {
//     static constexpr AboutSettings kAbout{"SomeOptions", "How a turn is searched for."};
//     double angle = 0.2;
//     int steps = 8;
//     InnerOptions inner;
//     std::uint64_t seed = 1;
//   };
//
//   template <SettingsOf<SomeOptions> Options, typename Visit>
//   void for_each_setting(Options& options, const Visit& visit) {
//     auto& [angle, steps, inner, seed] = options;  // does not compile while a field is missing
//     visit("angle", angle, kAbove0, "rad", "Largest turn of a step.");
//     visit("steps", steps, kAtLeast1, "", "Steps at most.");
//     visit("inner", inner, "Has settings of its own.");  // files have them as inner_NAME
//     visit.unlisted("seed", seed, kAtLeast0, "", "Of the steps.");
//     visit.relation("angle", angle <= inner.limit, "must be at most inner.limit");
//   }
//
// A number has a range (range.h) and a unit, "" for none; a flag, an enum (named_enum.h) and a
// struct have neither. What is unlisted stands in no file: it derives from another setting, such as
// a seed, or is asked for otherwise. SettingsOf accepts the struct both const (for writing a file)
// and mutable (for reading one).
template <typename T, typename Options>
concept SettingsOf = std::same_as<std::remove_const_t<T>, Options>;

// The name of a struct of options, and one sentence on what its settings decide.
struct AboutSettings {
  std::string_view name;
  std::string_view meaning;
};

}  // namespace prehend
