#include "sim/robot/files/xacro_parameters.h"

#include <cctype>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

bool is_blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

// The text up to the next blank that is outside of quotes and brackets, and without quotes around.
std::string take_default(std::string_view& rest) {
  std::size_t end = 0;
  int depth = 0;
  char mark = 0;
  for (; end < rest.size() && (depth > 0 || mark != 0 || !is_blank(rest[end])); ++end) {
    const char c = rest[end];
    if (mark != 0) {
      if (c == mark) mark = 0;
    } else if (c == '\'' || c == '"') {
      mark = c;
    } else {
      depth += c == '{' || c == '(' ? 1 : c == '}' || c == ')' ? -1 : 0;
    }
  }
  std::string text(rest.substr(0, end));
  rest.remove_prefix(end);
  const bool is_quoted = text.size() > 1 && (text.front() == '\'' || text.front() == '"') &&
                         text.back() == text.front();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

}  // namespace

std::vector<XacroParameter> xacro_parameters(std::string_view text) {
  std::vector<XacroParameter> parameters;
  for (std::string_view rest = text;;) {
    while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
    if (rest.empty()) return parameters;
    XacroParameter parameter;
    while (rest.starts_with('*')) {
      ++parameter.stars;
      rest.remove_prefix(1);
    }
    const auto is_of_name = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    while (!rest.empty() && is_of_name(rest.front())) {
      parameter.name += rest.front();
      rest.remove_prefix(1);
    }
    if (parameter.name.empty() || parameter.stars > 2) {
      throw InputError(
          {.problem = "params must be names, with defaults behind :=", .value = std::string(text)});
    }
    if (rest.starts_with(":=") || rest.starts_with('=')) {
      rest.remove_prefix(rest.front() == ':' ? 2 : 1);
      parameter.is_forwarded = rest.starts_with('^');
      if (parameter.is_forwarded) rest.remove_prefix(1);
      const bool has_default = !parameter.is_forwarded || rest.starts_with('|');
      if (rest.starts_with('|') && parameter.is_forwarded) rest.remove_prefix(1);
      if (has_default) parameter.otherwise = take_default(rest);
    }
    parameters.push_back(std::move(parameter));
  }
}

}  // namespace prehend
