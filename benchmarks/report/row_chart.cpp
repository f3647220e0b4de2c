#include "benchmarks/report/row_chart.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "benchmarks/report/plot_area.h"

namespace prehend::bench {
namespace {

constexpr double kRow = 20.0;    // height of a row
constexpr double kWide = 460.0;  // of the plot

// Room for the names at the left, and for the rows.
PlotArea area_for(const std::vector<std::string>& names) {
  return {26.0 + widest(names, 12.0), 46.0, kWide, kRow * static_cast<double>(names.size()) + 8.0};
}

double middle_of_row(const PlotArea& area, std::size_t i) {
  return area.top + 4.0 + kRow * (static_cast<double>(i) + 0.5);
}

void draw_names(Svg& svg, const PlotArea& area, const std::vector<std::string>& names) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    svg.text({area.left - 8.0, middle_of_row(area, i) + 4.0}, names[i], 12.0, Anchor::end);
  }
}

template <typename Row>
std::vector<std::string> names_of(const std::vector<Row>& rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) names.push_back(row.name);
  return names;
}

void draw_range(Svg& svg, const PlotArea& area, const Axis& axis, double y, const Summary& value) {
  const char* color = line_color(0);
  const double median = area.x_of(axis, value.median);
  const double p90 = area.x_of(axis, value.p90);
  svg.line({median, y}, {area.x_of(axis, value.p99), y}, color, 1.5);
  svg.line({p90, y - 5.0}, {p90, y + 5.0}, color, 2.0);
  svg.circle({median, y}, 4.0, color);
}

}  // namespace

std::string range_chart_svg(const RangeChart& given) {
  RangeChart chart = given;
  std::erase_if(chart.rows, [](const RangeRow& row) { return !(row.value.median > 0.0); });
  if (chart.rows.empty()) return {};
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  for (const RangeRow& row : chart.rows) {
    low = std::min(low, row.value.median);
    high = std::max({high, row.value.median, row.value.p99});
  }
  const Axis axis = make_axis(Scale::logarithmic, low, high);
  const std::vector<std::string> names = names_of(chart.rows);
  const PlotArea area = area_for(names);
  Svg svg(area.right() + 40.0, area.bottom() + 56.0, chart.title);
  draw_title(svg, {12.0, area.top, 0.0, 0.0}, chart.title);
  draw_x_axis(svg, area, axis, chart.label);
  draw_names(svg, area, names);
  for (std::size_t i = 0; i < chart.rows.size(); ++i) {
    draw_range(svg, area, axis, middle_of_row(area, i), chart.rows[i].value);
  }
  return svg.whole();
}

std::string share_chart_svg(const ShareChart& chart) {
  if (chart.rows.empty()) return {};
  const Axis axis = make_axis(Scale::linear, 0.0, 100.0);
  const std::vector<std::string> names = names_of(chart.rows);
  const PlotArea area = area_for(names);
  const double beside = 60.0 + widest(chart.parts, 12.0);
  const double legend_bottom = area.top + 20.0 * static_cast<double>(chart.parts.size()) + 12.0;
  Svg svg(area.right() + beside, std::max(area.bottom() + 56.0, legend_bottom), chart.title);
  draw_title(svg, {12.0, area.top, 0.0, 0.0}, chart.title);
  draw_x_axis(svg, area, axis, "share of the time [%]");
  draw_names(svg, area, names);
  for (std::size_t i = 0; i < chart.rows.size(); ++i) {
    const std::vector<double>& shares = chart.rows[i].shares;
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    double before = 0.0;
    for (std::size_t k = 0; k < shares.size() && sum > 0.0; ++k) {
      const double left = area.x_of(axis, 100.0 * before / sum);
      before += shares[k];
      const double right = area.x_of(axis, 100.0 * before / sum);
      svg.rectangle({left, middle_of_row(area, i) - 7.0}, right - left, 14.0, line_color(k));
    }
  }
  draw_legend(svg, {area.right() + 20.0, area.top + 4.0}, chart.parts);
  return svg.whole();
}

}  // namespace prehend::bench
