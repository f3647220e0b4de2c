#include "planner/show/page/page_text.h"

#include <stdexcept>

namespace prehend {
namespace {

constexpr std::string_view kData = "/*DATA*/";

// Makes JSON safe inside a script element, where "</script" would end the element and "<!--" begin
// a comment. In JSON text "<" occurs in strings only, where it may also be written as \u003c.
std::string script_safe(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace

std::string page_with_data(std::string_view page, const std::string& json) {
  const std::size_t at = page.find(kData);
  if (at == std::string_view::npos) throw std::logic_error("page.html: no place for the data");
  std::string filled(page.substr(0, at));
  filled += script_safe(json);
  filled += page.substr(at + kData.size());
  return filled;
}

std::string page_with(std::string page, std::string_view name, std::string_view value) {
  const std::string place = "{{" + std::string(name) + "}}";
  for (std::size_t at = page.find(place); at != std::string::npos;
       at = page.find(place, at + value.size())) {
    page.replace(at, place.size(), value);
  }
  return page;
}

}  // namespace prehend
