#include "sim/base/number_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "sim/base/input_error.h"

namespace prehend {

std::string number_text(double value) {
  if (!std::isfinite(value)) {
    throw InputError({.problem = "a number is not finite", .value = std::to_string(value)});
  }
  std::array<char, 32> buffer{};
  // Without a precision to_chars gives the shortest text that reads back as the same double. It may
  // have no point ("1", "1e-05"), which is then inserted.
  const auto end = std::to_chars(buffer.begin(), buffer.end(), value).ptr;
  std::string text(buffer.begin(), end);
  if (text.find('.') == std::string::npos) {
    const std::size_t exponent = text.find('e');
    text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  }
  return text;
}

}  // namespace prehend
