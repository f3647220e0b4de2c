#include "sim/robot/files/xacro_members.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <memory>
#include <utility>

#include "sim/base/input_error.h"

namespace prehend {
namespace {

using Map = std::map<std::string, XacroValue>;

[[noreturn]] void refuse(const std::string& problem, const std::string& value) {
  throw InputError({.problem = problem, .value = value});
}

std::string keys_of(const Map& map) {
  std::string keys;
  for (const auto& [key, value] : map) {
    if (keys.size() > 200) return keys + ", ...";
    keys += (keys.empty() ? "" : ", ") + key;
  }
  return keys;
}

std::string changed_case(std::string text, int (*change)(int)) {
  for (char& c : text) c = static_cast<char>(change(static_cast<unsigned char>(c)));
  return text;
}

std::string stripped(const std::string& text) {
  const auto is_blank = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
  const auto first = std::find_if_not(text.begin(), text.end(), is_blank);
  const auto last = std::find_if_not(text.rbegin(), text.rend(), is_blank).base();
  return first < last ? std::string(first, last) : std::string();
}

XacroValue split_at(const std::string& text, const std::string& mark) {
  if (mark.empty()) refuse("split needs a text to split at", text);
  std::vector<XacroValue> parts;
  std::size_t begin = 0;
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, begin)) {
    parts.push_back({text.substr(begin, at - begin)});
    begin = at + mark.size();
  }
  parts.push_back({text.substr(begin)});
  return {std::make_shared<const std::vector<XacroValue>>(std::move(parts))};
}

XacroValue replaced_in(const std::string& text, const std::string& old, const std::string& with) {
  if (old.empty()) refuse("replace needs a text to replace", text);
  std::string result;
  std::size_t begin = 0;
  for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, begin)) {
    result += text.substr(begin, at - begin) + with;
    begin = at + old.size();
  }
  return {result + text.substr(begin)};
}

XacroValue method_of_map(const Map& map, const std::string& name,
                         const std::vector<XacroValue>& arguments) {
  if (name == "get" && (arguments.size() == 1 || arguments.size() == 2)) {
    const auto found = map.find(text_of(arguments[0]));
    if (found != map.end()) return found->second;
    return arguments.size() == 2 ? arguments[1] : XacroValue{};
  }
  if (name == "keys" && arguments.empty()) {
    std::vector<XacroValue> keys;
    for (const auto& [key, value] : map) keys.push_back({key});
    return {std::make_shared<const std::vector<XacroValue>>(std::move(keys))};
  }
  refuse("maps have no such method here", name);
}

XacroValue method_of_text(const std::string& text, const std::string& name,
                          const std::vector<std::string>& words) {
  if (words.empty()) {
    if (name == "lower") return {changed_case(text, std::tolower)};
    if (name == "upper") return {changed_case(text, std::toupper)};
    if (name == "strip") return {stripped(text)};
  }
  if (words.size() == 1) {
    if (name == "startswith") return {text.starts_with(words[0])};
    if (name == "endswith") return {text.ends_with(words[0])};
    if (name == "split") return split_at(text, words[0]);
  }
  if (words.size() == 2 && name == "replace") return replaced_in(text, words[0], words[1]);
  refuse("texts have no such method here", name);
}

}  // namespace

const Map* as_map(const XacroValue& value) {
  const XacroMap* map = std::get_if<XacroMap>(&value.value);
  return map != nullptr ? map->get() : nullptr;
}

XacroValue element_of(const XacroValue& from, const XacroValue& which) {
  if (as_map(from) != nullptr) return member_of(from, text_of(which));
  const XacroList* list = std::get_if<XacroList>(&from.value);
  const std::string* text = std::get_if<std::string>(&from.value);
  const auto* whole = std::get_if<long long>(&which.value);
  if ((list == nullptr && text == nullptr) || whole == nullptr) {
    refuse("only lists, texts and maps have elements: by whole numbers, and of maps by names",
           text_of(which));
  }
  const auto size = static_cast<long long>(list != nullptr ? (*list)->size() : text->size());
  const long long at = *whole < 0 ? *whole + size : *whole;
  if (at < 0 || at >= size) refuse("there is no element of this number", text_of(which));
  const auto k = static_cast<std::size_t>(at);
  return list != nullptr ? (**list)[k] : XacroValue{text->substr(k, 1)};
}

XacroValue member_of(const XacroValue& from, const std::string& name) {
  const Map* map = as_map(from);
  if (map == nullptr) refuse("only what a YAML file holds has parts with names", name);
  const auto found = map->find(name);
  if (found == map->end()) refuse("there is no such part; there are " + keys_of(*map), name);
  return found->second;
}

XacroValue method_of(const XacroValue& from, const std::string& name,
                     const std::vector<XacroValue>& arguments) {
  if (const Map* map = as_map(from)) return method_of_map(*map, name, arguments);
  const std::string* text = std::get_if<std::string>(&from.value);
  if (text == nullptr) refuse("only maps and texts have methods here", name);
  std::vector<std::string> words;
  for (const XacroValue& argument : arguments) words.push_back(text_of(argument));
  return method_of_text(*text, name, words);
}

XacroValue xacro_value_of(const JsonField& field) {
  if (field.is_list()) {
    std::vector<XacroValue> values;
    for (const JsonField& item : field.items()) values.push_back(xacro_value_of(item));
    return {std::make_shared<const std::vector<XacroValue>>(std::move(values))};
  }
  if (field.is_object()) {
    Map map;
    for (const std::string& key : field.keys()) map[key] = xacro_value_of(field[key]);
    return {std::make_shared<const Map>(std::move(map))};
  }
  if (field.is_null()) return {};
  if (!field.is_text()) return literal_of(field.json());
  const std::string text = field.json() == "\"\"" ? std::string() : field.text();
  // As YAML 1.1 writes them, which Python reads.
  if (text == "True" || text == "False") return {text == "True"};
  return {text};
}

}  // namespace prehend
