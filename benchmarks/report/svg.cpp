#include "benchmarks/report/svg.h"

#include <array>

#include "sim/base/formatted.h"
#include "sim/base/xml/xml_text.h"

namespace prehend::bench {
namespace {

// Tenths of a pixel are more than anybody sees.
std::string points_text(const std::vector<SvgPoint>& points) {
  std::string text;
  for (const SvgPoint& point : points) text += formatted("%.1f,%.1f ", point.x, point.y);
  if (!text.empty()) text.pop_back();
  return text;
}

const char* anchor_name(Anchor anchor) {
  if (anchor == Anchor::middle) return "middle";
  return anchor == Anchor::end ? "end" : "start";
}

}  // namespace

double text_width(std::string_view text, double font_size) {
  double letters = 0.0;
  for (const char letter : text) {
    // Of a character of several bytes, only the first counts.
    if ((static_cast<unsigned char>(letter) & 0xC0U) != 0x80U) letters += 1.0;
  }
  return 0.58 * font_size * letters;
}

const char* line_color(std::size_t i) {
  constexpr std::array<const char*, 8> kColors = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                  "#e69f00", "#56b4e9", "#777777", "#a0522d"};
  return kColors.at(i % kColors.size());
}

Svg::Svg(double width, double height, const std::string& title) {
  head_ = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" "
      "height=\"%.0f\" font-family=\"Helvetica, Arial, sans-serif\">\n<title>%s</title>\n",
      width, height, width, height, markup_text(title).c_str());
  rectangle({0.0, 0.0}, width, height, "#ffffff");
}

void Svg::line(SvgPoint a, SvgPoint b, const std::string& color, double width, bool dashed) {
  body_ += formatted(
      "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\" "
      "stroke-width=\"%.1f\"%s/>\n",
      a.x, a.y, b.x, b.y, color.c_str(), width, dashed ? " stroke-dasharray=\"5 4\"" : "");
}

void Svg::polyline(const std::vector<SvgPoint>& points, const std::string& color, double width) {
  body_ += formatted(
      "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\" "
      "stroke-linejoin=\"round\"/>\n",
      points_text(points).c_str(), color.c_str(), width);
}

void Svg::polygon(const std::vector<SvgPoint>& points, const std::string& color, double opacity) {
  body_ += formatted("<polygon points=\"%s\" fill=\"%s\" fill-opacity=\"%.2f\"/>\n",
                     points_text(points).c_str(), color.c_str(), opacity);
}

void Svg::rectangle(SvgPoint corner, double width, double height, const std::string& color) {
  body_ += formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>\n",
                     corner.x, corner.y, width, height, color.c_str());
}

void Svg::circle(SvgPoint center, double radius, const std::string& color) {
  body_ += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>\n", center.x,
                     center.y, radius, color.c_str());
}

void Svg::text(SvgPoint at, std::string_view words, double size, Anchor anchor, bool turned,
               bool bold) {
  const std::string turn =
      turned ? formatted(" transform=\"rotate(-90 %.1f %.1f)\"", at.x, at.y) : std::string();
  body_ += formatted(
      "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.1f\" text-anchor=\"%s\" fill=\"#222222\"%s%s>%s"
      "</text>\n",
      at.x, at.y, size, anchor_name(anchor), bold ? " font-weight=\"bold\"" : "", turn.c_str(),
      markup_text(words).c_str());
}

std::string Svg::whole() const { return head_ + body_ + "</svg>\n"; }

}  // namespace prehend::bench
