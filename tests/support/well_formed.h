// Whether a text is well-formed XML, as far as SVG files of this project use it.
#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace prehend::test {

namespace xml_detail {

inline bool is_name(std::string_view text) {
  if (text.empty() || std::isalpha(static_cast<unsigned char>(text.front())) == 0) return false;
  for (const char letter : text) {
    const auto c = static_cast<unsigned char>(letter);
    if (std::isalnum(c) == 0 && letter != '-' && letter != ':' && letter != '_') return false;
  }
  return true;
}

// No character that XML reserves, but in one of its five names.
inline bool is_text(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '<' || text[i] == '"') return false;
    if (text[i] != '&') continue;
    bool known = false;
    for (const char* name : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
      known = known || text.substr(i).starts_with(name);
    }
    if (!known) return false;
  }
  return true;
}

// name="value" name="value" ..., each name once.
inline bool are_attributes(std::string_view text) {
  std::vector<std::string_view> names;
  while (!text.empty()) {
    if (text.front() != ' ') return false;
    text.remove_prefix(1);
    const std::size_t equals = text.find("=\"");
    if (equals == std::string_view::npos || !is_name(text.substr(0, equals))) return false;
    for (const std::string_view known : names) {
      if (known == text.substr(0, equals)) return false;
    }
    names.push_back(text.substr(0, equals));
    text.remove_prefix(equals + 2);
    const std::size_t end = text.find('"');
    if (end == std::string_view::npos || !is_text(text.substr(0, end))) return false;
    text.remove_prefix(end + 1);
  }
  return true;
}

}  // namespace xml_detail

// Elements that are nested and closed by name, one at the outside, with quoted attributes and
// escaped text. Declarations, comments and the like count as errors.
inline bool is_well_formed(std::string_view text) {
  std::vector<std::string> open;
  bool ended = false;
  while (!text.empty()) {
    if (text.front() != '<') {
      const std::string_view words = text.substr(0, text.find('<'));
      const bool blank = words.find_first_not_of(" \n") == std::string_view::npos;
      if ((open.empty() && !blank) || (!blank && !xml_detail::is_text(words))) return false;
      text.remove_prefix(words.size());
      continue;
    }
    const std::size_t end = text.find('>');
    if (end == std::string_view::npos || ended) return false;
    std::string_view tag = text.substr(1, end - 1);
    text.remove_prefix(end + 1);
    if (tag.starts_with("/")) {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else {
      const bool empty = tag.ends_with("/");
      if (empty) tag.remove_suffix(1);
      const std::string_view name = tag.substr(0, tag.find(' '));
      if (!xml_detail::is_name(name)) return false;
      if (!xml_detail::are_attributes(tag.substr(name.size()))) return false;
      if (!empty) open.emplace_back(name);
    }
    ended = open.empty();
  }
  return ended;
}

}  // namespace prehend::test
