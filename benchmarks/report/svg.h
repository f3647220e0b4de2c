// Pictures made of lines, shapes and words, as SVG.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace prehend::bench {

struct SvgPoint {
  double x = 0.0;
  double y = 0.0;  // downwards
};

enum class Anchor { start, middle, end };

// How wide text will be drawn, roughly: browsers choose the font [pixels].
double text_width(std::string_view text, double font_size);

// The colour of the i-th of several lines: eight that colour-blind people can tell apart (Okabe and
// Ito 2008), then again from the first.
const char* line_color(std::size_t i);

// A picture with a light background. Lengths are in pixels.
class Svg {
 public:
  Svg(double width, double height, const std::string& title);

  void line(SvgPoint a, SvgPoint b, const std::string& color, double width = 1.0,
            bool dashed = false);
  void polyline(const std::vector<SvgPoint>& points, const std::string& color, double width = 2.0);
  // Filled, and `opacity` of it seen.
  void polygon(const std::vector<SvgPoint>& points, const std::string& color, double opacity);
  void rectangle(SvgPoint corner, double width, double height, const std::string& color);
  void circle(SvgPoint center, double radius, const std::string& color);
  // `at` is on the line on which letters stand. `turned`: reads upwards.
  void text(SvgPoint at, std::string_view words, double size = 12.0, Anchor anchor = Anchor::start,
            bool turned = false, bool bold = false);

  // The finished picture.
  std::string whole() const;

 private:
  std::string head_;
  std::string body_;
};

}  // namespace prehend::bench
