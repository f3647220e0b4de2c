// The data in a report's page, as a browser finds it.
#pragma once

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "planner/show/report/report.h"
#include "planner/show/report/report_html.h"

namespace prehend::test {

// A script element ends at the first "</script".
inline nlohmann::json data_of(const std::string& html) {
  const std::string open = R"(<script type="application/json" id="data">)";
  const std::size_t first = html.find(open) + open.size();
  const std::size_t end = html.find("</script", first);
  EXPECT_EQ(html.substr(0, first) + "/*DATA*/" + html.substr(end), report_page());
  const std::string text = html.substr(first, end - first);
  EXPECT_EQ(text.find('<'), std::string::npos);
  nlohmann::json data = nlohmann::json::parse(text, nullptr, false);
  EXPECT_TRUE(data.is_object()) << text.substr(0, 200);
  return data;
}

inline nlohmann::json data_of(const Report& report) { return data_of(report_html(report)); }

// Where numbers stand, as no JSON can say "not a number".
inline void expect_numbers(const nlohmann::json& json, const std::string& where) {
  if (json.is_array()) {
    ASSERT_FALSE(json.empty()) << where;
    for (const nlohmann::json& item : json) expect_numbers(item, where);
  } else {
    EXPECT_TRUE(json.is_number()) << where << ": " << json;
  }
}

}  // namespace prehend::test
