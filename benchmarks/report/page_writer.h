// Markdown with tables and pictures, from its beginning to its end.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/report/page.h"

namespace prehend::bench {

// A value with its unit, in three digits; times in the unit that suits them: "12.3 ms", "4.56 µs",
// "80 /s". A value without a dimension has the unit "1", which is not shown.
std::string value_text(double value, const std::string& unit);

class PageWriter {
 public:
  void heading(int level, const std::string& words);
  void paragraph(const std::string& words);
  // Rows with as many cells as there are headings. Nothing without rows.
  void table(const std::vector<std::string>& headings,
             const std::vector<std::vector<std::string>>& rows);
  // A picture in a file NAME.svg beside the page; nothing where `svg` is empty.
  void picture(const std::string& name, const std::string& words, const std::string& svg);

  // The pictures, and the page last: who finds the page finds them all.
  std::vector<PageFile> files() &&;

 private:
  std::string text_;
  std::vector<PageFile> pictures_;
};

}  // namespace prehend::bench
