// Goes through the settings that structs of options declare (settings.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "sim/base/range.h"
#include "sim/base/settings.h"

namespace prehend {

// The name of a setting in code, and the one in files, where that is another one. The settings of a
// struct have the name of the struct in files before their own, which may be empty.
struct SettingName {
  std::string_view name;
  std::string_view in_files;

  // NOLINTNEXTLINE(google-explicit-constructor): most settings have one name.
  constexpr SettingName(const char* both) : name(both), in_files(both) {}
  constexpr SettingName(const char* in_code, const char* in_file)
      : name(in_code), in_files(in_file) {}
};

// What is declared of one setting.
struct Setting {
  SettingName name;
  std::string_view meaning = {};
  Range range = kAnyNumber;  // of a number
  std::string_view unit = {};
  bool listed = true;  // in files of settings
};

// What for_each_setting is given: it calls leaf(setting, value) for every field, and
// leaf.relation(name, holds, problem) for every relation if the leaf has such a function.
template <typename Leaf>
class SettingVisitor {
 public:
  explicit SettingVisitor(const Leaf& leaf) : leaf_(leaf) {}

  template <typename Number>
  void operator()(SettingName name, Number& value, const Range& range, std::string_view unit,
                  std::string_view meaning) const {
    leaf_(Setting{name, meaning, range, unit}, value);
  }
  template <typename Value>
  void operator()(SettingName name, Value& value, std::string_view meaning) const {
    leaf_(Setting{name, meaning}, value);
  }
  template <typename Number>
  void unlisted(SettingName name, Number& value, const Range& range, std::string_view unit,
                std::string_view meaning) const {
    leaf_(Setting{name, meaning, range, unit, false}, value);
  }
  template <typename Value>
  void unlisted(SettingName name, Value& value, std::string_view meaning) const {
    leaf_(Setting{name, meaning, kAnyNumber, {}, false}, value);
  }

  // Two settings that have to fit to each other; `problem` says how, for the setting `name`.
  void relation(SettingName name, bool holds, std::string_view problem) const {
    if constexpr (requires { leaf_.relation(name, holds, problem); }) {
      leaf_.relation(name, holds, problem);
    }
  }

 private:
  const Leaf& leaf_;
};

namespace detail {
// A leaf that does nothing; for the concept below only.
struct AnySetting {
  void operator()(const Setting&, auto&) const {}
};

template <typename T>
inline constexpr bool kIsOptional = false;
template <typename T>
inline constexpr bool kIsOptional<std::optional<T>> = true;
}  // namespace detail

// True for structs of options with a function for_each_setting.
template <typename T>
concept HasSettings = requires(T& options, const SettingVisitor<detail::AnySetting>& visit) {
  for_each_setting(options, visit);
};

// Calls leaf(name, value, setting) for every listed value in `options` and, recursively, in nested
// structs of options, with the name that it has in files: that of a nested value is OUTER_INNER, or
// INNER alone where the name of the struct in files is empty.
template <HasSettings Options, typename Leaf>
void visit_settings(Options& options, const Leaf& leaf, const std::string& prefix = "") {
  const auto visit = [&](const Setting& setting, auto& value) {
    if (!setting.listed) return;
    const std::string whole = prefix + std::string(setting.name.in_files);
    if constexpr (HasSettings<std::remove_reference_t<decltype(value)>>) {
      visit_settings(value, leaf, setting.name.in_files.empty() ? prefix : whole + "_");
    } else if constexpr (!detail::kIsOptional<std::remove_cvref_t<decltype(value)>>) {
      leaf(whole, value, setting);
    }
  };
  for_each_setting(options, SettingVisitor(visit));
}

}  // namespace prehend
