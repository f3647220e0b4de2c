#include "planner/report/report_html.h"

#include "planner/report/report_json.h"

namespace prehend {
namespace {

// Inside a script element only "<" can end it or open a comment; JSON has another way to write it.
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
