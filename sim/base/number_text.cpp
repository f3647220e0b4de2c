#include "sim/base/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "sim/base/input_error.h"

namespace prehend {

std::string shortest_text(double value) {
  // Without a precision to_chars gives the shortest text that reads back as the same double.
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string number_text(double value) {
  if (!std::isfinite(value)) {
    throw InputError({.problem = "a number is not finite", .value = std::to_string(value)});
  }
  std::string text = shortest_text(value);
  if (text.find('.') == std::string::npos) {
    const std::size_t exponent = text.find('e');
    text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  }
  return text;
}

}  // namespace prehend
