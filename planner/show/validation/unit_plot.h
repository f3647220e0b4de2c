// Plots of shares over shares, as SVG inside a page: both axes go from 0 to 1.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim/quality/interval.h"

namespace prehend {

struct PlotPoint {
  double x = 0.0;
  double y = 0.0;
};

// Colours come from the style sheet of the page: what has the number i is of the class "c<i>",
// axes, grid and words of the classes "axis", "grid" and "words".
class UnitPlot {
 public:
  UnitPlot(std::string_view title, std::string_view x_label, std::string_view y_label);

  void diagonal();
  void line(const std::vector<PlotPoint>& points, std::size_t color);
  // A point with its interval along y; its size says how many there are of it.
  void dot(PlotPoint at, const Interval& y, double radius, std::size_t color);
  // Between x and x, from 0 upwards.
  void bar(const Interval& x, double height);

  std::string svg() const;

 private:
  std::string head_;
  std::string body_;
};

// An interval with its value in one line of a table, on a scale from 0 to 1 with a mark at 0.5.
std::string interval_svg(double value, const Interval& interval);

}  // namespace prehend
