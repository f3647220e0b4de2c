// Quantities of many things, one row each.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/report/results.h"

namespace prehend::bench {

struct RangeRow {
  std::string name;
  Summary value;
};

// Median (dot), 90 % (short line) and 99 % (end of the thin line) of each row over a logarithmic
// axis.
struct RangeChart {
  std::string title;
  std::string label;  // of the axis, with the unit
  std::vector<RangeRow> rows;
};

// Empty where no row has a median above 0; rows without one are left out.
std::string range_chart_svg(const RangeChart& given);

struct ShareRow {
  std::string name;
  std::vector<double> shares;  // as many as ShareChart::parts; at least 0
};

// What a whole is made of, as a bar a row; shares are drawn as parts of their sum.
struct ShareChart {
  std::string title;
  std::vector<std::string> parts;
  std::vector<ShareRow> rows;
};

// Empty without rows; rows whose sum is 0 have no bar.
std::string share_chart_svg(const ShareChart& chart);

}  // namespace prehend::bench
