#include "planner/report/report_html.h"

#include "planner/report/report_json.h"

namespace prehend {
namespace {

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

std::string report_html(const Report& report) {
  return std::string(page_before_data()) + script_safe(report_json(report)) +
         std::string(page_after_data());
}

}  // namespace prehend
