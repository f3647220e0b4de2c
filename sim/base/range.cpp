#include "sim/base/range.h"

#include "sim/base/formatted.h"

namespace prehend {

std::string Range::words() const {
  if (!std::isfinite(lower)) return "must be a number";
  std::string text = formatted(without_lower ? "must be above %g" : "must be at least %g", lower);
  if (std::isfinite(upper)) text += formatted(" and at most %g", upper);
  return text;
}

std::string Range::interval() const {
  if (!std::isfinite(lower)) return "";
  if (!std::isfinite(upper)) return formatted(without_lower ? "> %g" : ">= %g", lower);
  return formatted(without_lower ? "(%g, %g]" : "[%g, %g]", lower, upper);
}

}  // namespace prehend
