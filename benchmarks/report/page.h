// Results as a page in Markdown with plots as SVG.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/report/results.h"

namespace prehend::bench {

struct PageFile {
  std::string name;  // in the folder of the page
  std::string content;
};

// The page, "results.md", and the plots that it refers to. The same results give the same bytes.
// Parts that the results do not have are left out.
std::vector<PageFile> page_of(const Results& results);

}  // namespace prehend::bench
