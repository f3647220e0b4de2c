// Numbers as text in a given format.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace prehend {

// What std::printf would print of these values, of any length.
template <typename... Values>
std::string formatted(const char* pattern, Values... values) {
  const int size = std::snprintf(nullptr, 0, pattern, values...);
  std::string text(static_cast<std::size_t>(size), '\0');
  std::snprintf(text.data(), text.size() + 1, pattern, values...);
  return text;
}

}  // namespace prehend
