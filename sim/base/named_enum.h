// Enums whose values count from 0 without gaps and have a name each, as in files. The names stand
// beside the enum, in its order; values, look-ups and tables come from them:
//
//   enum class Accuracy { draft, standard, fine };
//   constexpr auto enum_names(Accuracy /*of*/) {
//     return std::to_array<std::string_view>({"draft", "standard", "fine"});
//   }
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

namespace prehend {

template <typename Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires {
  enum_names(Enum{});
};

// All values, in their order.
template <NamedEnum Enum>
inline constexpr auto kAll = [] {
  std::array<Enum, enum_names(Enum{}).size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Enum>(i);
  return values;
}();

template <NamedEnum Enum>
constexpr std::string_view name_of(Enum value) {
  constexpr auto kNames = enum_names(Enum{});
  return kNames[static_cast<std::size_t>(value)];
}

// The value with this name; nothing for any other text.
template <NamedEnum Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
  for (const Enum value : kAll<Enum>) {
    if (name_of(value) == name) return value;
  }
  return std::nullopt;
}

// A table with an entry for each value.
template <NamedEnum Enum, typename T>
struct EnumArray {
  std::array<T, kAll<Enum>.size()> entries{};

  constexpr T& operator[](Enum value) { return entries[static_cast<std::size_t>(value)]; }
  constexpr const T& operator[](Enum value) const {
    return entries[static_cast<std::size_t>(value)];
  }
  bool operator==(const EnumArray& other) const = default;
};

}  // namespace prehend
