// Lists as text.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace prehend {

// The texts of `parts` one after the other, with `between` between two of them. text(part): the
// text of one, or a pointer to the member that has it.
template <typename Parts, typename Text>
std::string joined(const Parts& parts, std::string_view between, const Text& text) {
  std::string all;
  bool first = true;
  for (const auto& part : parts) {
    if (!first) all += between;
    all += std::invoke(text, part);
    first = false;
  }
  return all;
}

// The same of parts that are texts.
template <typename Parts>
std::string joined(const Parts& parts, std::string_view between = ", ") {
  return joined(parts, between, [](std::string_view part) { return part; });
}

// Adds a part to a list that grows part by part.
inline void add_part(std::string& list, std::string_view part, std::string_view between = ", ") {
  if (!list.empty()) list += between;
  list += part;
}

}  // namespace prehend
