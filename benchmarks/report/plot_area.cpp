#include "benchmarks/report/plot_area.h"

#include <algorithm>

namespace prehend::bench {
namespace {

constexpr const char* kGrid = "#e4e4e4";
constexpr const char* kFrame = "#555555";

}  // namespace

void draw_x_axis(Svg& svg, const PlotArea& area, const Axis& axis, const std::string& label) {
  for (const Tick& tick : axis.ticks) {
    const double x = area.x_of(axis, tick.value);
    svg.line({x, area.top}, {x, area.bottom()}, kGrid);
    svg.line({x, area.bottom()}, {x, area.bottom() + 4.0}, kFrame);
    svg.text({x, area.bottom() + 18.0}, tick.label, 12.0, Anchor::middle);
  }
  svg.line({area.left, area.bottom()}, {area.right(), area.bottom()}, kFrame);
  svg.text({area.left + area.width / 2.0, area.bottom() + 38.0}, label, 13.0, Anchor::middle);
}

void draw_y_axis(Svg& svg, const PlotArea& area, const Axis& axis, const std::string& label) {
  for (const Tick& tick : axis.ticks) {
    const double y = area.y_of(axis, tick.value);
    svg.line({area.left, y}, {area.right(), y}, kGrid);
    svg.line({area.left - 4.0, y}, {area.left, y}, kFrame);
    svg.text({area.left - 8.0, y + 4.0}, tick.label, 12.0, Anchor::end);
  }
  svg.line({area.left, area.top}, {area.left, area.bottom()}, kFrame);
  svg.text({area.left - 52.0, area.top + area.height / 2.0}, label, 13.0, Anchor::middle, true);
}

void draw_title(Svg& svg, const PlotArea& area, const std::string& title) {
  svg.text({area.left, area.top - 16.0}, title, 14.0, Anchor::start, false, true);
}

void draw_legend(Svg& svg, SvgPoint corner, const std::vector<std::string>& names) {
  constexpr double kLine = 20.0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double y = corner.y + kLine * static_cast<double>(i);
    svg.rectangle({corner.x, y}, 14.0, 10.0, line_color(i));
    svg.text({corner.x + 20.0, y + 9.0}, names[i], 12.0);
  }
}

double widest(const std::vector<std::string>& names, double font_size) {
  double width = 0.0;
  for (const std::string& name : names) width = std::max(width, text_width(name, font_size));
  return width;
}

}  // namespace prehend::bench
