// The part of a picture inside the axes of a plot.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/report/axis.h"
#include "benchmarks/report/svg.h"

namespace prehend::bench {

struct PlotArea {
  double left = 0.0;  // pixels
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
  double x_of(const Axis& axis, double value) const { return left + axis.place(value) * width; }
  double y_of(const Axis& axis, double value) const {
    return bottom() - axis.place(value) * height;
  }
};

// Grid lines, ticks and the label below, or to the left.
void draw_x_axis(Svg& svg, const PlotArea& area, const Axis& axis, const std::string& label);
void draw_y_axis(Svg& svg, const PlotArea& area, const Axis& axis, const std::string& label);

// The title over the area.
void draw_title(Svg& svg, const PlotArea& area, const std::string& title);

// Names with their colours, one below the other, from `corner` down; colours are line_color(i).
void draw_legend(Svg& svg, SvgPoint corner, const std::vector<std::string>& names);

// The width that the widest of the names takes [pixels].
double widest(const std::vector<std::string>& names, double font_size);

}  // namespace prehend::bench
