#include "sim/base/range.h"

#include <string_view>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/number_text.h"

namespace prehend {
namespace {

// 1e6 and 1e-9, not 1e+06 and 1e-09.
std::string short_text(double value) {
  std::string text = formatted("%g", value);
  for (const auto& [padded, plain] : {std::pair("e+0", "e"), {"e+", "e"}, {"e-0", "e-"}}) {
    if (const auto at = text.find(padded); at != std::string::npos) {
      text.replace(at, std::string_view(padded).size(), plain);
    }
  }
  return text;
}

}  // namespace

std::string Range::words() const {
  if (!std::isfinite(lower)) return "must be a number";
  if (lower == -upper) return "must be within " + short_text(upper) + " of 0";
  std::string text = without_lower ? "must be above " : "must be at least ";
  text += short_text(lower);
  if (std::isfinite(upper)) text += " and at most " + short_text(upper);
  return text;
}

std::string Range::interval() const {
  if (!std::isfinite(lower)) return "";
  if (!std::isfinite(upper)) return (without_lower ? "> " : ">= ") + short_text(lower);
  return (without_lower ? "(" : "[") + short_text(lower) + ", " + short_text(upper) + "]";
}

void require_in(const Range& range, double value, std::string_view field) {
  if (range.contains(value)) return;
  throw InputError(
      {.field = std::string(field), .problem = range.words(), .value = shortest_text(value)});
}

}  // namespace prehend
