#include "sim/base/json/wrapped_json.h"

#include <nlohmann/json.hpp>

namespace prehend {
namespace {

constexpr std::size_t kLine = 100;  // characters

std::string on_a_line(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// With a space after each comma and colon between the items.
std::string spaced(const nlohmann::ordered_json& value) {
  if (!value.is_structured()) return on_a_line(value);
  std::string text(1, value.is_array() ? '[' : '{');
  const char* separator = "";
  for (const auto& item : value.items()) {
    text += separator;
    if (value.is_object()) text += on_a_line(item.key()) + ": ";
    text += spaced(item.value());
    separator = ", ";
  }
  return text + (value.is_array() ? ']' : '}');
}

// Whether the value is too large for a line, found without making its text.
bool has_more_items_than(const nlohmann::ordered_json& value, std::size_t most) {
  if (!value.is_structured()) return false;
  std::size_t items = value.size();
  for (const nlohmann::ordered_json& item : value) {
    if (items > most) return true;
    if (item.is_structured()) items += item.size();
  }
  return items > most;
}

void add_wrapped(const nlohmann::ordered_json& value, std::size_t indent, std::size_t used,
                 std::string& text) {
  if (!value.is_structured() || value.empty()) {
    text += spaced(value);
    return;
  }
  if (!has_more_items_than(value, kLine)) {
    const std::string line = spaced(value);
    if (indent + used + line.size() < kLine) {
      text += line;
      return;
    }
  }
  text += value.is_array() ? '[' : '{';
  const char* separator = "\n";
  for (const auto& item : value.items()) {
    text += separator + std::string(indent + 2, ' ');
    std::size_t before = 0;
    if (value.is_object()) {
      const std::string key = on_a_line(item.key()) + ": ";
      text += key;
      before = key.size();
    }
    add_wrapped(item.value(), indent + 2, before, text);
    separator = ",\n";
  }
  text += '\n' + std::string(indent, ' ') + (value.is_array() ? ']' : '}');
}

}  // namespace

std::string wrapped_json(const nlohmann::ordered_json& value) {
  std::string text;
  add_wrapped(value, 0, 0, text);
  return text + '\n';
}

}  // namespace prehend
