#include "benchmarks/report/line_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "benchmarks/report/plot_area.h"
#include "sim/base/formatted.h"

namespace prehend::bench {
namespace {

bool has_place(const LinePlot& plot, const LinePoint& point) {
  return (plot.x_scale == Scale::linear || point.x > 0.0) &&
         (plot.y_scale == Scale::linear || point.y > 0.0);
}

LinePlot without_placeless_points(LinePlot plot) {
  for (Line& line : plot.lines) {
    std::erase_if(line.points, [&](const LinePoint& point) { return !has_place(plot, point); });
    for (LinePoint& point : line.points) {
      // A spread down to 0 ends at the point.
      if (plot.y_scale == Scale::logarithmic && !(point.low > 0.0)) point.low = point.y;
    }
  }
  return plot;
}

// The ends of what is to be seen along both axes.
struct Extent {
  double x_low = std::numeric_limits<double>::infinity();
  double x_high = -std::numeric_limits<double>::infinity();
  double y_low = std::numeric_limits<double>::infinity();
  double y_high = -std::numeric_limits<double>::infinity();
};

Extent extent_of(const LinePlot& plot) {
  Extent extent;
  for (const Line& line : plot.lines) {
    for (const LinePoint& point : line.points) {
      extent.x_low = std::min(extent.x_low, point.x);
      extent.x_high = std::max(extent.x_high, point.x);
      extent.y_low = std::min({extent.y_low, point.low, point.y});
      extent.y_high = std::max({extent.y_high, point.high, point.y});
    }
  }
  // Lengths of bars and curves from zero can be compared.
  if (plot.x_scale == Scale::linear) extent.x_low = std::min(extent.x_low, 0.0);
  if (plot.y_scale == Scale::linear) extent.y_low = std::min(extent.y_low, 0.0);
  return extent;
}

std::vector<std::string> legend_of(const LinePlot& plot) {
  std::vector<std::string> names;
  for (const Line& line : plot.lines) {
    names.push_back(line.name);
    if (line.fit) names.back() += formatted(": exponent %.2f", line.fit->exponent);
  }
  return names;
}

// The fitted line from the first point to the last, as far as it lies inside the plot.
void draw_fit(Svg& svg, const PlotArea& area, const Axis& x, const Axis& y, const Line& line,
              const char* color) {
  if (!line.fit || line.points.size() < 2) return;
  constexpr int kPieces = 40;  // a straight line in logarithmic axes, but not in others
  const double first = x.place(line.points.front().x);
  const double last = x.place(line.points.back().x);
  const auto value_at = [&](double place) {
    return x.scale == Scale::linear ? x.low + place * (x.high - x.low)
                                    : x.low * std::pow(x.high / x.low, place);
  };
  SvgPoint before;
  bool drawn = false;
  for (int i = 0; i <= kPieces; ++i) {
    const double place = first + (last - first) * i / kPieces;
    const double height = y.place(line.fit->at(value_at(place)));
    const SvgPoint here{area.left + place * area.width, area.bottom() - height * area.height};
    const bool inside = height >= 0.0 && height <= 1.0;
    if (drawn && inside) svg.line(before, here, color, 1.2);
    drawn = inside;
    before = here;
  }
}

void draw_line(Svg& svg, const PlotArea& area, const Axis& x, const Axis& y, const Line& line,
               const char* color) {
  std::vector<SvgPoint> middle;
  std::vector<SvgPoint> band;
  std::vector<SvgPoint> lower;
  for (const LinePoint& point : line.points) {
    middle.push_back({area.x_of(x, point.x), area.y_of(y, point.y)});
    band.push_back({area.x_of(x, point.x), area.y_of(y, point.high)});
    lower.push_back({area.x_of(x, point.x), area.y_of(y, point.low)});
  }
  band.insert(band.end(), lower.rbegin(), lower.rend());
  if (middle.size() > 1) svg.polygon(band, color, 0.18);
  draw_fit(svg, area, x, y, line, color);
  // Where a law was fitted, that is the line.
  if (!line.fit && middle.size() > 1) svg.polyline(middle, color);
  for (const SvgPoint& point : middle) svg.circle(point, 3.5, color);
}

}  // namespace

std::string line_plot_svg(const LinePlot& given) {
  const LinePlot plot = without_placeless_points(given);
  const Extent extent = extent_of(plot);
  if (!(extent.x_low <= extent.x_high)) return {};
  const Axis x = make_axis(plot.x_scale, extent.x_low, extent.x_high);
  const Axis y = make_axis(plot.y_scale, extent.y_low, extent.y_high);
  const std::vector<std::string> legend = legend_of(plot);
  const PlotArea area{80.0, 46.0, 480.0, 320.0};
  const double beside = std::max(60.0, 50.0 + widest(legend, 12.0));
  const double width =
      std::max(area.right() + beside, area.left + widest({plot.title}, 14.0) * 1.1);
  Svg svg(width, area.bottom() + 56.0, plot.title);
  draw_title(svg, area, plot.title);
  draw_x_axis(svg, area, x, plot.x_label);
  draw_y_axis(svg, area, y, plot.y_label);
  for (std::size_t i = 0; i < plot.lines.size(); ++i) {
    draw_line(svg, area, x, y, plot.lines[i], line_color(i));
  }
  draw_legend(svg, {area.right() + 20.0, area.top + 4.0}, legend);
  return svg.whole();
}

}  // namespace prehend::bench
