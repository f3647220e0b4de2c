#include "sim/robot/files/xacro_expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/number_text.h"
#include "sim/robot/files/xacro_members.h"
#include "sim/robot/files/xacro_parser.h"

namespace prehend {
namespace {

constexpr std::size_t kLongestText = 100000;

using Kind = XacroNode::Kind;
using Values = std::vector<XacroValue>;

[[noreturn]] void fail(const std::string& problem, const std::string& value = "") {
  throw InputError({.problem = problem, .value = value});
}

const std::string* as_text(const XacroValue& value) {
  return std::get_if<std::string>(&value.value);
}

const std::vector<XacroValue>* as_list(const XacroValue& value) {
  const XacroList* list = std::get_if<XacroList>(&value.value);
  return list ? list->get() : nullptr;
}

std::optional<long long> as_whole(const XacroValue& value) {
  if (const auto* whole = std::get_if<long long>(&value.value)) return *whole;
  if (const auto* truth = std::get_if<bool>(&value.value)) return *truth ? 1 : 0;
  return std::nullopt;
}

double number_of(const XacroValue& value, const std::string& needed_by) {
  if (const auto* real = std::get_if<double>(&value.value)) return *real;
  if (const auto whole = as_whole(value)) return static_cast<double>(*whole);
  fail(needed_by + " needs a number", text_of(value));
}

// As Python's bool().
bool is_true(const XacroValue& value) {
  if (const std::string* text = as_text(value)) return !text->empty();
  if (const auto* list = as_list(value)) return !list->empty();
  if (const auto* map = as_map(value)) return !map->empty();
  if (std::holds_alternative<std::monostate>(value.value)) return false;
  return number_of(value, "a condition") != 0.0;
}

bool equal(const XacroValue& a, const XacroValue& b) {
  if (as_text(a) || as_text(b)) return as_text(a) && as_text(b) && *as_text(a) == *as_text(b);
  const auto* first = as_list(a);
  const auto* second = as_list(b);
  if (first || second) {
    return first && second &&
           std::equal(first->begin(), first->end(), second->begin(), second->end(), equal);
  }
  if (as_map(a) || as_map(b)) return as_map(a) == as_map(b);
  const bool none = std::holds_alternative<std::monostate>(a.value);
  if (none || std::holds_alternative<std::monostate>(b.value))
    return a.value.index() == b.value.index();
  return number_of(a, "==") == number_of(b, "==");
}

bool contains(const XacroValue& part, const XacroValue& whole) {
  if (as_text(whole) && as_text(part))
    return as_text(whole)->find(*as_text(part)) != std::string::npos;
  if (const auto* map = as_map(whole)) return map->contains(text_of(part));
  const auto* list = as_list(whole);
  if (!list) fail("in needs a list", text_of(whole));
  return std::any_of(list->begin(), list->end(),
                     [&](const XacroValue& v) { return equal(v, part); });
}

// Numbers that a whole number of a double can hold, so that sums and products are exact.
constexpr double kLargestWhole = 1e15;

// Of two whole numbers a whole one, else a real one.
XacroValue number_like(double value, bool whole) {
  if (whole && std::abs(value) <= kLargestWhole) return {static_cast<long long>(value)};
  if (!std::isfinite(value)) fail("the result is no finite number");
  return {value};
}

XacroValue arithmetic(const std::string& sign, const XacroValue& a, const XacroValue& b) {
  if (sign == "+" && as_text(a) && as_text(b)) return {*as_text(a) + *as_text(b)};
  const double x = number_of(a, sign);
  const double y = number_of(b, sign);
  const bool whole = as_whole(a) && as_whole(b);
  if (sign == "+") return number_like(x + y, whole);
  if (sign == "-") return number_like(x - y, whole);
  if (sign == "*") return number_like(x * y, whole);
  if (sign == "**") return number_like(std::pow(x, y), whole && y >= 0.0);
  if (y == 0.0) fail("division by 0");
  if (sign == "/") return number_like(x / y, false);
  const double floored = std::floor(x / y);
  return number_like(sign == "//" ? floored : x - y * floored, whole);
}

bool compares(const std::string& sign, const XacroValue& a, const XacroValue& b) {
  if (sign == "==") return equal(a, b);
  if (sign == "!=") return !equal(a, b);
  if (sign == "in") return contains(a, b);
  if (sign == "not in") return !contains(a, b);
  const auto ordered = [&](const auto& x, const auto& y) {
    if (sign == "<") return x < y;
    if (sign == ">") return x > y;
    return sign == "<=" ? x <= y : x >= y;
  };
  if (as_text(a) && as_text(b)) return ordered(*as_text(a), *as_text(b));
  return ordered(number_of(a, sign), number_of(b, sign));
}

struct MathFunction {
  std::string_view name;
  double (*value)(double);
};

constexpr double kRadiansOfDegree = std::numbers::pi / 180.0;

constexpr std::array<MathFunction, 12> kFunctions{{
    {"sin", [](double x) { return std::sin(x); }},
    {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},
    {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},
    {"atan", [](double x) { return std::atan(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"exp", [](double x) { return std::exp(x); }},
    {"log", [](double x) { return std::log(x); }},
    {"fabs", [](double x) { return std::abs(x); }},
    {"radians", [](double x) { return x * kRadiansOfDegree; }},
    {"degrees", [](double x) { return x / kRadiansOfDegree; }},
}};

// Python rounds halves to even.
XacroValue rounded(const std::string& name, const Values& values) {
  const double x = number_of(values[0], name);
  if (name == "round" && values.size() == 2) {
    const double power = std::pow(10.0, number_of(values[1], name));
    return number_like(std::nearbyint(x * power) / power, false);
  }
  if (name == "round") return number_like(std::nearbyint(x), true);
  return number_like(name == "floor"  ? std::floor(x)
                     : name == "ceil" ? std::ceil(x)
                                      : std::trunc(x),
                     true);
}

XacroValue converted_to(const std::string& name, const XacroValue& value) {
  if (name == "str") return {text_of(value)};
  if (name == "bool") return {is_true(value)};
  const XacroValue number = as_text(value) ? literal_of(*as_text(value)) : value;
  if (name == "float") return {number_of(number, name)};
  return rounded("int", {number});
}

XacroValue extreme(const std::string& name, const Values& values) {
  const Values& among = values.size() == 1 && as_list(values[0]) ? *as_list(values[0]) : values;
  if (among.empty()) fail(name + " needs values");
  const XacroValue* best = &among.front();
  for (const XacroValue& value : among) {
    if (compares(name == "max" ? ">" : "<", value, *best)) best = &value;
  }
  return *best;
}

XacroValue called(const std::string& name, const Values& values, XacroWords& words) {
  const auto need = [&](std::size_t least, std::size_t most) {
    if (values.size() < least || values.size() > most) fail("wrong number of arguments", name);
  };
  if (name == "min" || name == "max") return extreme(name, values);
  if (name == "atan2" || name == "pow" || name == "hypot") {
    need(2, 2);
    const double a = number_of(values[0], name);
    const double b = number_of(values[1], name);
    if (name == "pow") return arithmetic("**", values[0], values[1]);
    return number_like(name == "atan2" ? std::atan2(a, b) : std::hypot(a, b), false);
  }
  need(1, name == "round" ? 2 : 1);
  if (name == "round" || name == "floor" || name == "ceil") return rounded(name, values);
  if (name == "int" || name == "float" || name == "str" || name == "bool") {
    return converted_to(name, values[0]);
  }
  if (name == "abs")
    return number_like(std::abs(number_of(values[0], name)), as_whole(values[0]).has_value());
  if (name == "len") {
    if (const std::string* text = as_text(values[0])) return {static_cast<long long>(text->size())};
    if (const auto* list = as_list(values[0])) return {static_cast<long long>(list->size())};
    if (const auto* map = as_map(values[0])) return {static_cast<long long>(map->size())};
    fail("len needs a text, a list or a map");
  }
  if (name == "arg") return literal_of(words.command("arg " + text_of(values[0])));
  if (name == "load_yaml") return words.load_yaml(text_of(values[0]));
  for (const MathFunction& function : kFunctions) {
    if (function.name == name)
      return number_like(function.value(number_of(values[0], name)), false);
  }
  fail(
      "the function cannot be read here; expand the file with xacro first (xacro FILE > FILE.urdf)",
      name);
}

XacroValue constant_or_property(const std::string& name, XacroWords& words) {
  if (name == "pi") return {std::numbers::pi};
  if (name == "tau") return {2.0 * std::numbers::pi};
  if (name == "e") return {std::numbers::e};
  return words.property(name);
}

// Parts of which the value does not depend are not computed, as in Python.
XacroValue value_of(const XacroNode& node, XacroWords& words) {
  const auto part = [&](std::size_t k) { return value_of(node.parts[k], words); };
  const auto all = [&] {
    Values values;
    for (const XacroNode& each : node.parts) values.push_back(value_of(each, words));
    return values;
  };
  switch (node.kind) {
    case Kind::literal:
      return node.value;
    case Kind::name:
      return constant_or_property(node.word, words);
    case Kind::call:
      return called(node.word, all(), words);
    case Kind::list: {
      Values values = all();
      // What holds itself many times over could never be compared.
      const auto has_parts = [](const XacroValue& v) { return as_list(v) || as_map(v); };
      if (std::any_of(values.begin(), values.end(), has_parts)) {
        fail("lists of lists cannot be read");
      }
      return {std::make_shared<const Values>(std::move(values))};
    }
    case Kind::index:
      return element_of(part(0), part(1));
    case Kind::member:
      if (node.parts[0].kind == Kind::name) {
        if (auto found = words.property_of(node.parts[0].word, node.word)) return *found;
      }
      return member_of(part(0), node.word);
    case Kind::method: {
      Values values = all();
      const XacroValue from = values.front();
      values.erase(values.begin());
      return method_of(from, node.word, values);
    }
    case Kind::choose:
      return is_true(part(0)) ? part(1) : part(2);
    case Kind::unary:
      if (node.word == "not") return {!is_true(part(0))};
      return arithmetic(node.word, {0LL}, part(0));
    case Kind::binary:
      break;
  }
  XacroValue first = part(0);
  if (node.word == "and" || node.word == "or") {
    return is_true(first) == (node.word == "and") ? part(1) : first;
  }
  constexpr std::string_view kArithmetic = "+-*/%";
  if (kArithmetic.find(node.word.front()) != std::string::npos) {
    return arithmetic(node.word, first, part(1));
  }
  return {compares(node.word, first, part(1))};
}

// The end of what a bracket at `open` begins, outside of quotes.
std::size_t closing_of(std::string_view text, std::size_t open) {
  const char up = text[open];
  const char down = up == '{' ? '}' : ')';
  int depth = 0;
  char mark = 0;
  for (std::size_t k = open; k < text.size(); ++k) {
    const char c = text[k];
    if (mark != 0) {
      if (c == mark) mark = 0;
    } else if (c == '\'' || c == '"') {
      if (up == '{') mark = c;
    } else if (c == up) {
      ++depth;
    } else if (c == down && --depth == 0) {
      return k;
    }
  }
  fail("a bracket is not closed", std::string(text));
}

// What stands behind a $, as a value.
XacroValue replaced(std::string_view text, std::size_t open, std::size_t end, XacroWords& words) {
  const std::string_view inside = text.substr(open + 1, end - open - 1);
  if (text[open] == '{') {
    const bool has_commands = inside.find("$(") != std::string_view::npos;
    return xacro_expression(has_commands ? xacro_text(inside, words) : std::string(inside), words);
  }
  const std::string command = xacro_text(inside, words);
  if (command.starts_with("eval ")) return xacro_expression(command.substr(5), words);
  return {words.command(command)};
}

}  // namespace

XacroValue xacro_expression(std::string_view text, XacroWords& words) {
  return value_of(parse_xacro(text), words);
}

XacroValue literal_of(const std::string& text) {
  if (text == "true" || text == "True") return {true};
  if (text == "false" || text == "False") return {false};
  const bool is_quoted = text.size() > 1 && (text.front() == '\'' || text.front() == '"') &&
                         text.back() == text.front();
  if (is_quoted) return {text.substr(1, text.size() - 2)};
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* const end = text.data() + text.size();
  long long whole = 0;
  const auto [stop, wrong] = std::from_chars(begin, end, whole);
  if (wrong == std::errc() && stop == end && begin != end) return {whole};
  double real = 0.0;
  const auto [last, error] = std::from_chars(begin, end, real);
  if (error == std::errc() && last == end && std::isfinite(real)) return {real};
  return {text};
}

std::string text_of(const XacroValue& value) {
  if (const std::string* text = as_text(value)) return *text;
  if (const auto* truth = std::get_if<bool>(&value.value)) return *truth ? "True" : "False";
  if (const auto* whole = std::get_if<long long>(&value.value)) return std::to_string(*whole);
  if (const auto* real = std::get_if<double>(&value.value)) {
    const std::string text = shortest_text(*real);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
  }
  if (std::holds_alternative<std::monostate>(value.value)) return "None";
  const auto* list = as_list(value);
  std::string text = list ? "[" : "{";
  const auto add = [&](const std::string& part) {
    if (text.size() + part.size() > kLongestText)
      fail("a text grows to more than 100,000 characters");
    text += (text.size() > 1 ? ", " : "") + part;
  };
  if (list) {
    for (const XacroValue& part : *list) add(text_of(part));
    return text + "]";
  }
  for (const auto& [key, part] : *as_map(value)) add("'" + key + "': " + text_of(part));
  return text + "}";
}

std::string xacro_text(std::string_view text, XacroWords& words) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t sign = std::min(text.find('$', at), text.size());
    result += text.substr(at, sign - at);
    at = sign;
    if (at == text.size()) break;
    const char next = at + 1 < text.size() ? text[at + 1] : 0;
    if (next == '{' || next == '(') {
      const std::size_t end = closing_of(text, at + 1);
      result += text_of(replaced(text, at + 1, end, words));
      at = end + 1;
    } else {
      result += '$';
      at += next == '$' ? 2 : 1;
    }
    if (result.size() > kLongestText) fail("a text grows to more than 100,000 characters");
  }
  return result;
}

XacroValue xacro_value(std::string_view text, XacroWords& words) {
  const bool opens = text.starts_with("${") || text.starts_with("$(");
  if (opens && closing_of(text, 1) + 1 == text.size()) {
    XacroValue value = replaced(text, 1, text.size() - 1, words);
    return text[1] == '(' && as_text(value) ? literal_of(*as_text(value)) : value;
  }
  return literal_of(xacro_text(text, words));
}

bool holds(const XacroValue& value) {
  if (as_text(value) || as_list(value) || as_map(value) ||
      std::holds_alternative<std::monostate>(value.value)) {
    fail("a condition must be true, false or a number", text_of(value));
  }
  return is_true(value);
}

}  // namespace prehend
