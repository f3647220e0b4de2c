#include "benchmarks/report/page.h"

#include <gtest/gtest.h>

#include "benchmarks/report/page_writer.h"
#include "benchmarks/report/peers.h"
#include "tests/support/sample_results.h"
#include "tests/support/well_formed.h"

namespace prehend::bench {
namespace {

std::string markdown_of(const Results& results) { return page_of(results).back().content; }

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Page, IsMadeAgainByteByByte) {
  const std::vector<PageFile> once = page_of(test::sample_results());
  const std::vector<PageFile> again = page_of(test::sample_results());
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].name, again[i].name);
    EXPECT_EQ(once[i].content, again[i].content);
  }
}

TEST(Page, RefersToEachPlotAndEachIsXml) {
  const std::vector<PageFile> files = page_of(test::sample_results());
  ASSERT_EQ(files.back().name, "results.md");
  EXPECT_EQ(files.size(), 7U);
  for (std::size_t i = 0; i + 1 < files.size(); ++i) {
    EXPECT_TRUE(has(files.back().content, "](" + files[i].name + ")")) << files[i].name;
    EXPECT_TRUE(test::is_well_formed(files[i].content)) << files[i].name;
  }
}

TEST(Page, ShowsWhatWasMeasured) {
  const std::string page = markdown_of(test::sample_results());
  EXPECT_TRUE(has(page, "| inside test | 250 ns |")) << page;
  EXPECT_TRUE(has(page, "| barrett, mug | 4 ms |"));
  EXPECT_TRUE(has(page, "| path with its check, shelf | 120 ms |"));
  EXPECT_TRUE(has(page, "| made ready | 1.00 | 1.000 |"));
  EXPECT_TRUE(has(page, "| squared | 2.00 | 1.000 |"));
  EXPECT_TRUE(has(page, "| processor | A processor <& co> |"));
  EXPECT_FALSE(has(page, "not measurements to quote"));
}

TEST(Page, SaysWhereTheKneeIs) {
  Results results = test::sample_results();
  EXPECT_TRUE(has(markdown_of(results), "the default spends 4.0 times that"))
      << markdown_of(results);
  for (Entry& entry : results.entries) {
    if (entry.group == kDefault) entry.value = summarize({200.0});
  }
  EXPECT_TRUE(has(markdown_of(results), "the default is at it"));
  EXPECT_TRUE(has(markdown_of(results), "| mug, standard | 200 | 2 s | 0.15 | 8 s | 0.152 |"))
      << markdown_of(results);
}

TEST(Page, HasTheStagesThatARunHas) {
  const std::string page = markdown_of(test::sample_results());
  EXPECT_TRUE(has(page, "| scene, options | runs | whole run | trials | report |")) << page;
  EXPECT_TRUE(has(page, "| mug | 3 | 900 ms | 500 ms |  |")) << page;
  EXPECT_TRUE(has(page, "| mug, draft | 3 | 400 ms |  | 150 ms |")) << page;
}

TEST(Page, WarnsOfWhatIsNotToBeQuoted) {
  Results results = test::sample_results();
  results.effort = "smoke";
  EXPECT_TRUE(has(markdown_of(results), "not measurements to quote"));
}

TEST(Page, OfOnePartHasNoOther) {
  Results results = test::sample_results();
  std::erase_if(results.entries, [](const Entry& entry) { return entry.part != kKernels; });
  const std::vector<PageFile> files = page_of(results);
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files.front().name, "kernels.svg");
  EXPECT_FALSE(has(files.back().content, "## Scaling"));
  results.entries.clear();
  EXPECT_EQ(page_of(results).size(), 1U);
}

TEST(Page, SetsPeersBesideOurs) {
  const std::string page = markdown_of(test::sample_results());
  EXPECT_TRUE(has(page, "**Measured elsewhere**"));
  for (const PeerFigure& figure : peer_figures()) {
    EXPECT_FALSE(std::string(figure.source).empty()) << figure.what;
    EXPECT_TRUE(has(page, figure.figure)) << figure.what;
  }
  EXPECT_TRUE(has(page, "| 4 ms | 4.13 ms | `trials/trial in contact/barrett, mug` |")) << page;
}

TEST(PageWriter, ValuesHaveThreeDigitsAndAUnitThatSuits) {
  EXPECT_EQ(value_text(0.0, "ms"), "0 ns");
  EXPECT_EQ(value_text(1234.0, "ns"), "1.23 µs");
  EXPECT_EQ(value_text(999.7, "us"), "1 ms");
  EXPECT_EQ(value_text(0.0123, "s"), "12.3 ms");
  EXPECT_EQ(value_text(75.0, "s"), "75 s");
  EXPECT_EQ(value_text(1234.0, "MB"), "1234 MB");
  EXPECT_EQ(value_text(0.01234, "1"), "0.0123");
  EXPECT_EQ(value_text(81.23, "1/s"), "81.2 /s");
}

TEST(PageWriter, CellsCannotEndThemselves) {
  PageWriter writer;
  writer.table({"a"}, {{"x | y"}});
  EXPECT_TRUE(has(std::move(writer).files().back().content, "| x \\| y |"));
}

}  // namespace
}  // namespace prehend::bench
