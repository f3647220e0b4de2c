#include "planner/show/validation/unit_plot.h"

#include <array>

#include "sim/base/formatted.h"
#include "sim/base/xml/xml_text.h"

namespace prehend {
namespace {

// Pixels: the square between the axes, and the room for words to its left and below.
constexpr double kSide = 320.0;
constexpr double kLeft = 56.0;
constexpr double kTop = 12.0;
constexpr double kBelow = 48.0;
constexpr double kRight = 16.0;

double x_at(double share) { return kLeft + share * kSide; }
double y_at(double share) { return kTop + (1.0 - share) * kSide; }

std::string words_at(double x, double y, std::string_view words, const char* anchor,
                     const std::string& turn = "") {
  return formatted(R"(<text class="words" x="%.1f" y="%.1f" text-anchor="%s"%s>)", x, y, anchor,
                   turn.c_str()) +
         markup_text(words) + "</text>\n";
}

std::string grid_of_axes() {
  std::string text;
  for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const char* kind = share == 0.0 ? "axis" : "grid";
    text += formatted("<path class=\"%s\" d=\"M%.1f %.1fV%.1fM%.1f %.1fH%.1f\"/>\n", kind,
                      x_at(share), y_at(0.0), y_at(1.0), x_at(0.0), y_at(share), x_at(1.0));
    const std::string number = formatted("%g", share);
    text += words_at(x_at(share), y_at(0.0) + 17.0, number, "middle");
    text += words_at(x_at(0.0) - 7.0, y_at(share) + 4.0, number, "end");
  }
  return text;
}

}  // namespace

UnitPlot::UnitPlot(std::string_view title, std::string_view x_label, std::string_view y_label) {
  const double width = kLeft + kSide + kRight;
  const double height = kTop + kSide + kBelow;
  head_ = formatted(
      "<svg class=\"plot\" role=\"img\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" "
      "height=\"%.0f\">\n",
      width, height, width, height);
  head_ += "<title>" + markup_text(title) + "</title>\n" + grid_of_axes();
  head_ += words_at(x_at(0.5), y_at(0.0) + 40.0, x_label, "middle");
  const double middle = y_at(0.5);
  head_ += words_at(15.0, middle, y_label, "middle",
                    formatted(" transform=\"rotate(-90 15 %.1f)\"", middle));
}

void UnitPlot::diagonal() {
  body_ += formatted("<path class=\"diagonal\" d=\"M%.1f %.1fL%.1f %.1f\"/>\n", x_at(0.0),
                     y_at(0.0), x_at(1.0), y_at(1.0));
}

void UnitPlot::line(const std::vector<PlotPoint>& points, std::size_t color) {
  if (points.empty()) return;
  body_ += formatted(R"(<polyline class="line c%zu" points=")", color);
  for (const PlotPoint& point : points) {
    body_ += formatted("%.1f,%.1f ", x_at(point.x), y_at(point.y));
  }
  body_.back() = '"';
  body_ += "/>\n";
}

void UnitPlot::dot(PlotPoint at, const Interval& y, double radius, std::size_t color) {
  body_ += formatted("<path class=\"line c%zu\" d=\"M%.1f %.1fV%.1f\"/>\n", color, x_at(at.x),
                     y_at(y.lower), y_at(y.upper));
  body_ += formatted("<circle class=\"dot c%zu\" cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>\n", color,
                     x_at(at.x), y_at(at.y), radius);
}

void UnitPlot::bar(const Interval& x, double height) {
  body_ += formatted("<rect class=\"bar\" x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\"/>\n",
                     x_at(x.lower) + 1.0, y_at(height), (x.upper - x.lower) * kSide - 2.0,
                     height * kSide);
}

std::string UnitPlot::svg() const { return head_ + body_ + "</svg>\n"; }

std::string interval_svg(double value, const Interval& interval) {
  constexpr double kLength = 160.0;
  return formatted(
      "<svg class=\"range\" role=\"img\" viewBox=\"-4 0 %.0f 16\" width=\"%.0f\" height=\"16\">"
      "<path class=\"grid\" d=\"M0 8H%.0f\"/><path class=\"axis\" d=\"M%.1f 3V13\"/><path "
      "class=\"line c0\" d=\"M%.1f 8H%.1f\"/>"
      "<circle class=\"dot c0\" cx=\"%.1f\" cy=\"8\" r=\"3.5\"/></svg>",
      kLength + 8.0, kLength + 8.0, kLength, 0.5 * kLength, interval.lower * kLength,
      interval.upper * kLength, value * kLength);
}

}  // namespace prehend
