#include <gtest/gtest.h>

#include "benchmarks/report/line_plot.h"
#include "benchmarks/report/row_chart.h"
#include "benchmarks/report/svg.h"
#include "tests/support/well_formed.h"

namespace prehend::bench {
namespace {

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(WellFormed, TellsWhatIsNot) {
  EXPECT_TRUE(test::is_well_formed("<a b=\"1\"><c/>words &amp; more</a>\n"));
  for (const char* text : {"", "words", "<a>", "<a></b>", "<a/><b/>", "<a b=1/>", "<a>a & b</a>",
                           "<a b=\"<\"/>", "<a b=\"1\" b=\"2\"/>", "<a><b></a></b>"}) {
    EXPECT_FALSE(test::is_well_formed(text)) << text;
  }
}

TEST(Svg, EscapesWords) {
  Svg svg(100.0, 50.0, "a < b & \"c\"");
  svg.text({1.0, 2.0}, "x > y", 12.0, Anchor::end, true, true);
  const std::string text = svg.whole();
  EXPECT_TRUE(test::is_well_formed(text)) << text;
  EXPECT_NE(text.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
}

TEST(Svg, WidthCountsCharactersNotBytes) {
  EXPECT_DOUBLE_EQ(text_width("ε", 12.0), text_width("e", 12.0));
}

TEST(LinePlot, ShowsEachPointAndTheExponent) {
  LinePlot plot{"time & size", "size", "time [ms]", Scale::logarithmic, Scale::logarithmic, {}};
  Line line{"mug <1>", {{1.0, 2.0, 1.0, 3.0}, {10.0, 20.0, 0.0, 30.0}, {0.0, 5.0, 5.0, 5.0}}, {}};
  line.fit = PowerLaw{1.0, 2.0, 1.0};
  plot.lines = {line, {"other", {{2.0, 4.0, 4.0, 4.0}}, {}}};
  const std::string svg = line_plot_svg(plot);
  EXPECT_TRUE(test::is_well_formed(svg)) << svg;
  // The point at 0 has no place on the logarithmic axis.
  EXPECT_EQ(count_of(svg, "<circle"), 3U);
  EXPECT_NE(svg.find("mug &lt;1&gt;: exponent 1.00"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(LinePlot, IsEmptyWithoutPoints) {
  EXPECT_TRUE(line_plot_svg({}).empty());
  LinePlot plot{"t", "x", "y", Scale::logarithmic, Scale::linear, {{"a", {{0.0, 1.0}}, {}}}};
  EXPECT_TRUE(line_plot_svg(plot).empty());
}

TEST(RowChart, HasARowForEachThing) {
  const RangeChart ranges{
      "t", "ns", {{"a", summarize({1.0, 2.0})}, {"none", {}}, {"b", summarize({1e3, 1e4})}}};
  const std::string svg = range_chart_svg(ranges);
  EXPECT_TRUE(test::is_well_formed(svg)) << svg;
  EXPECT_EQ(count_of(svg, "<circle"), 2U);
  EXPECT_TRUE(range_chart_svg({}).empty());
}

TEST(RowChart, SharesFillTheRow) {
  const ShareChart chart{"t", {"one", "two"}, {{"a", {1.0, 3.0}}, {"none", {0.0, 0.0}}}};
  const std::string svg = share_chart_svg(chart);
  EXPECT_TRUE(test::is_well_formed(svg)) << svg;
  // 460 pixels are the whole.
  EXPECT_NE(svg.find("width=\"115.0\""), std::string::npos) << svg;
  EXPECT_NE(svg.find("width=\"345.0\""), std::string::npos) << svg;
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_TRUE(share_chart_svg({}).empty());
}

}  // namespace
}  // namespace prehend::bench
