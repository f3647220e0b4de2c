#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "planner/bulk/design/design_series.h"
#include "planner/show/page/plain_page.h"
#include "sim/base/csv_row.h"
#include "sim/base/formatted.h"
#include "sim/base/xml/xml_text.h"

namespace prehend {
namespace {

// Colours that remain apart for colour-blind readers (Okabe and Ito 2008).
constexpr std::string_view kDesignStyle = R"(
:root { --c0: #0072b2; --c1: #d55e00; --c2: #009e73; --c3: #cc79a7; --c4: #8a6d00; --c5: #56b4e9; }
@media (prefers-color-scheme: dark) { :root { --c0: #4da3e0; --c1: #ff8a4c; --c4: #e6c24a; } }
.axis { stroke: var(--pale); fill: none; } .words { fill: var(--pale); font-size: 12px; }
.line { fill: none; stroke-width: 2; } svg { max-width: 100%; height: auto; }
)";
constexpr std::size_t kColors = 6;

// Pixels.
constexpr double kWidth = 640.0;
constexpr double kHeight = 320.0;
constexpr double kLeft = 60.0;
constexpr double kRight = 150.0;  // for the names
constexpr double kTop = 16.0;
constexpr double kBelow = 48.0;

std::vector<std::string> objects_of(const std::vector<DesignPoint>& points) {
  std::vector<std::string> names;
  for (const DesignPoint& point : points) {
    if (std::find(names.begin(), names.end(), point.object) == names.end()) {
      names.push_back(point.object);
    }
  }
  return names;
}

// A round number not below `value`, for the end of an axis.
double round_above(double value) {
  if (value <= 0.0) return 1.0;
  const double unit = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * unit >= value) return factor * unit;
  }
  return 10.0 * unit;
}

// Epsilon of the best grasp of each object over the value.
class DesignPlot {
 public:
  DesignPlot(const std::vector<DesignPoint>& points, const HandVariation& variation)
      : points_(points), variation_(variation) {
    double most = 0.0;
    for (const DesignPoint& point : points) most = std::max(most, point.epsilon);
    top_ = round_above(most);
  }

  std::string svg() const {
    std::string text = formatted(
        "<svg role=\"img\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" height=\"%.0f\">\n"
        "<title>epsilon of the best grasp over %s</title>\n",
        kWidth, kHeight, kWidth, kHeight, markup_text(variation_.name()).c_str());
    text += axes();
    const std::vector<std::string> names = objects_of(points_);
    for (std::size_t k = 0; k < names.size(); ++k) text += line(names[k], k);
    return text + "</svg>\n";
  }

 private:
  double x_at(double value) const {
    const double lower = std::min(variation_.from, variation_.to);
    const double span = std::abs(variation_.to - variation_.from);
    const double share = span > 0.0 ? (value - lower) / span : 0.5;
    return kLeft + share * (kWidth - kLeft - kRight);
  }
  double y_at(double epsilon) const {
    return kTop + (1.0 - epsilon / top_) * (kHeight - kTop - kBelow);
  }

  static std::string words(double x, double y, const std::string& text, const char* anchor) {
    return formatted(R"(<text class="words" x="%.1f" y="%.1f" text-anchor="%s">)", x, y, anchor) +
           markup_text(text) + "</text>\n";
  }

  std::string axes() const {
    std::string text = formatted("<path class=\"axis\" d=\"M%.1f %.1fV%.1fH%.1f\"/>\n", kLeft,
                                 y_at(top_), y_at(0.0), kWidth - kRight);
    for (const double share : {0.0, 0.5, 1.0}) {
      const double value = variation_.from + share * (variation_.to - variation_.from);
      text += words(x_at(value), y_at(0.0) + 18.0, formatted("%.4g", value), "middle");
      text += words(kLeft - 6.0, y_at(share * top_) + 4.0, formatted("%.3g", share * top_), "end");
    }
    text += words(0.5 * (kLeft + kWidth - kRight), kHeight - 8.0, variation_.name(), "middle");
    return text + words(kLeft + 6.0, kTop + 4.0, "epsilon of the best grasp", "start");
  }

  std::string line(const std::string& object, std::size_t k) const {
    const std::string color = formatted("var(--c%zu)", k % kColors);
    std::string path;
    std::string dots;
    double last = 0.0;
    for (const DesignPoint& point : points_) {
      if (point.object != object) continue;
      const double x = x_at(point.value);
      last = y_at(point.epsilon);
      path += formatted("%s%.1f %.1f", path.empty() ? "M" : "L", x, last);
      dots += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"%s\"/>\n", x, last,
                        color.c_str());
    }
    return formatted("<path class=\"line\" stroke=\"%s\" d=\"%s\"/>\n", color.c_str(),
                     path.c_str()) +
           dots +
           formatted(R"(<text x="%.1f" y="%.1f" font-size="12" fill="%s">)", kWidth - kRight + 8.0,
                     last + 4.0, color.c_str()) +
           markup_text(object) + "</text>\n";
  }

  const std::vector<DesignPoint>& points_;
  const HandVariation& variation_;
  double top_ = 1.0;
};

std::string rows_of(const std::vector<DesignPoint>& points) {
  std::string rows;
  for (const DesignPoint& point : points) {
    rows +=
        row_of({formatted("%.4g", point.value), markup_text(point.object),
                formatted("%.4f", point.epsilon), formatted("%d of %d", point.stable, point.trials),
                formatted("%.0f", 1000.0 * point.opening), markup_text(point.problem)});
  }
  return rows;
}

}  // namespace

std::string design_csv(const std::vector<DesignPoint>& points, const HandVariation& variation) {
  CsvRow head;
  for (const std::string& name :
       {variation.name(), std::string("object"), std::string("epsilon"), std::string("stable"),
        std::string("trials"), std::string("opening_m"), std::string("problem")}) {
    head.text(name);
  }
  std::string text = head.line();
  for (const DesignPoint& point : points) {
    CsvRow row;
    row.number(point.value);
    row.text(point.object);
    row.number(point.epsilon);
    row.number(point.stable);
    row.number(point.trials);
    row.number(point.opening);
    row.text(point.problem);
    text += row.line();
  }
  return text;
}

std::string design_table(const std::vector<DesignPoint>& points, const HandVariation& variation) {
  std::string text = formatted("%-20s %-20s %8s %14s %12s\n", variation.name().c_str(), "object",
                               "epsilon", "stable trials", "opening [mm]");
  for (const DesignPoint& point : points) {
    text += formatted("%-20.4g %-20s ", point.value, point.object.c_str());
    text += point.problem.empty() ? formatted("%8.4f %6d of %4d %12.0f\n", point.epsilon,
                                              point.stable, point.trials, 1000.0 * point.opening)
                                  : point.problem + "\n";
  }
  return text;
}

std::string design_page(const std::vector<DesignPoint>& points, const HandVariation& variation,
                        const std::string& hand) {
  const std::string body =
      "<p>Each hand closes on each object as the planner does it, with openings derived "
      "anew.</p>\n" +
      DesignPlot(points, variation).svg() +
      table_of(
          {markup_text(variation.name()), "object", "epsilon", "stable trials", "opening [mm]", ""},
          rows_of(points));
  return plain_page(hand + ": " + variation.name(), kDesignStyle, body);
}

}  // namespace prehend
