// Pages of text, tables and pictures, without scripts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace prehend {

// A whole page with this title as its heading. `title` is text, `style` more rules for the few that
// every page has, `body` markup.
std::string plain_page(std::string_view title, std::string_view style, std::string_view body);

// A table's row of cells, which are markup, and a table of such rows. Wide tables scroll.
std::string row_of(const std::vector<std::string>& cells, const char* tag = "td");
std::string table_of(const std::vector<std::string>& heads, const std::string& rows);

}  // namespace prehend
