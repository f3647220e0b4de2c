#include "sim/robot/files/graspit_expression.h"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

#include "sim/base/range.h"

namespace prehend {
namespace {

bool take(std::string_view& text, char c) {
  if (!text.starts_with(c)) return false;
  text.remove_prefix(1);
  return true;
}

// A number with any signs before it, taken from the front of the text.
std::optional<double> take_number(std::string_view& text) {
  double sign = 1.0;
  for (int signs = 0; signs < 2; ++signs) {
    if (take(text, '-')) {
      sign = -sign;
    } else {
      take(text, '+');
    }
  }
  if (text.starts_with('-')) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !(std::abs(value) <= kLargestNumber)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return sign * value;
}

std::optional<int> take_dof(std::string_view& text) {
  int dof = 0;
  const bool digit = !text.empty() && text.front() >= '0' && text.front() <= '9';
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), dof);
  if (!digit || error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return dof;
}

}  // namespace

std::optional<GraspitExpression> graspit_expression(std::string_view text) {
  std::string packed;
  for (const char c : text) {
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') packed += c;
  }
  std::string_view rest = packed;
  GraspitExpression expression;
  if (take(rest, 'd')) {
    expression.dof = take_dof(rest);
    if (!expression.dof) return std::nullopt;
    if (take(rest, '*')) {
      const std::optional<double> ratio = take_number(rest);
      if (!ratio) return std::nullopt;
      expression.ratio = *ratio;
    }
    if (rest.empty()) return expression;
    if (!rest.starts_with('+') && !rest.starts_with('-')) return std::nullopt;
  }
  const std::optional<double> constant = take_number(rest);
  if (!constant || !rest.empty()) return std::nullopt;
  expression.constant = *constant;
  return expression;
}

}  // namespace prehend
