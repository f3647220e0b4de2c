// The check of options at the entry of a public function.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "sim/base/settings.h"
#include "sim/base/visit_settings.h"

namespace prehend {

// A setting that is out of its range, or does not fit to another one.
struct SettingFault {
  std::string path;      // of the field from the options, such as "search.batch"
  std::string in_files;  // its name in files of settings, such as "contact_gap"
  std::string problem;   // such as "must be at least 1"
  std::string value;     // empty for a relation between two
};

namespace detail {

// Where the check is: the structs that the setting is nested in, from the innermost outwards.
struct SettingPlace {
  const SettingPlace* outer;
  const SettingName& name;
};

SettingFault fault_of_range(const SettingPlace& place, const Range& range, double value);
SettingFault fault_of_relation(const SettingPlace& place, std::string_view problem);

template <HasSettings Options>
void find_fault(const Options& options, const SettingPlace* outer,
                std::optional<SettingFault>& fault);

// Finds the first fault. Nothing is allocated while there is none.
struct FaultFinder {
  const SettingPlace* outer;
  std::optional<SettingFault>& fault;

  template <typename Value>
  void operator()(const Setting& setting, const Value& value) const {
    const SettingPlace place{outer, setting.name};
    if constexpr (HasSettings<const Value>) {
      find_fault(value, &place, fault);
    } else if constexpr (kIsOptional<Value>) {
      if constexpr (HasSettings<const typename Value::value_type>) {
        if (value) find_fault(*value, &place, fault);
      }
    } else if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
      const auto number = static_cast<double>(value);
      if (setting.range.contains(number) || fault) return;
      fault = fault_of_range(place, setting.range, number);
    }
  }

  void relation(const SettingName& name, bool holds, std::string_view problem) const {
    if (!holds && !fault) fault = fault_of_relation({outer, name}, problem);
  }
};

template <HasSettings Options>
void find_fault(const Options& options, const SettingPlace* outer,
                std::optional<SettingFault>& fault) {
  const FaultFinder finder{outer, fault};
  for_each_setting(options, SettingVisitor(finder));
}

[[noreturn]] void refuse(const SettingFault& fault);

}  // namespace detail

// The first setting of the options, or of those nested in them, that no function accepts; nothing
// where all are right.
template <HasSettings Options>
std::optional<SettingFault> setting_fault(const Options& options) {
  std::optional<SettingFault> fault;
  detail::find_fault(options, nullptr, fault);
  return fault;
}

// Throws InputError with the path of the field, what its range is, and its value, for a setting out
// of its range or one that does not fit to another. A few nanoseconds a setting: a function that
// takes a millisecond may check at each call.
template <HasSettings Options>
void require_settings(const Options& options) {
  if (const std::optional<SettingFault> fault = setting_fault(options)) detail::refuse(*fault);
}

}  // namespace prehend
