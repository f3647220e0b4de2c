// Quantities over a size or a time, as lines in a plot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "benchmarks/report/axis.h"
#include "benchmarks/report/power_law.h"

namespace prehend::bench {

// A point of a line, with the spread of its y.
struct LinePoint {
  double x = 0.0;
  double y = 0.0;
  double low = 0.0;
  double high = 0.0;
};

struct Line {
  std::string name;
  std::vector<LinePoint> points;  // x ascending
  std::optional<PowerLaw> fit;    // drawn instead of the line, its exponent in the legend
};

struct LinePlot {
  std::string title;
  std::string x_label;  // with the unit
  std::string y_label;
  Scale x_scale = Scale::linear;
  Scale y_scale = Scale::linear;
  std::vector<Line> lines;
};

// The plot as SVG: a line with its points each, the spread as a band behind it, and a legend beside
// the plot. On a logarithmic axis, points without a logarithm are left out. An empty text where no
// point is left.
std::string line_plot_svg(const LinePlot& given);

}  // namespace prehend::bench
