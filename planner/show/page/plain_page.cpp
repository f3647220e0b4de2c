#include "planner/show/page/plain_page.h"

#include "sim/base/formatted.h"
#include "sim/base/xml/xml_text.h"

namespace prehend {
namespace {

constexpr std::string_view kPlainStyle = R"(
:root { color-scheme: light dark; --back: #fff; --ink: #1c2126; --pale: #68727c; --rule: #dce1e6;
  --bar: #e9edf1; --warn: #fff4d6; }
@media (prefers-color-scheme: dark) { :root { --back: #15191d; --ink: #e4e8ec; --pale: #98a3ad;
  --rule: #333b43; --bar: #242b32; --warn: #3d3310; } }
body { margin: 2rem auto; padding: 0 1rem; max-width: 68rem; background: var(--back);
  color: var(--ink); font: 15px/1.5 system-ui, sans-serif; }
h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2.2rem; }
p { max-width: 46rem; } .note, caption { color: var(--pale); }
.warning { background: var(--warn); padding: .6rem .9rem; border-radius: .3rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .7rem; border-bottom: 1px solid var(--rule); text-align: right;
  white-space: nowrap; }
th:first-child, td:first-child { text-align: left; padding-left: 0; }
th { color: var(--pale); font-weight: 600; vertical-align: bottom; white-space: normal; }
)";

}  // namespace

std::string plain_page(std::string_view title, std::string_view style, std::string_view body) {
  const std::string heading = markup_text(std::string(title));
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>";
  page += heading + "</title>\n<style>";
  page.append(kPlainStyle).append(style).append("</style>\n</head>\n<body>\n<h1>");
  page += heading + "</h1>\n";
  page.append(body).append("</body>\n</html>\n");
  return page;
}

std::string row_of(const std::vector<std::string>& cells, const char* tag) {
  std::string row = "<tr>";
  for (const std::string& cell : cells) row += formatted("<%s>%s</%s>", tag, cell.c_str(), tag);
  return row + "</tr>\n";
}

std::string table_of(const std::vector<std::string>& heads, const std::string& rows) {
  return "<div class=\"wide\"><table>\n" + row_of(heads, "th") + rows + "</table></div>\n";
}

}  // namespace prehend
