#include "benchmarks/report/compare.h"

#include <cmath>

#include <gtest/gtest.h>

namespace prehend::bench {
namespace {

Entry measured(const std::string& series, const std::string& unit, double median) {
  return {"kernels", "call", series, {}, unit, summarize({median})};
}

Results results_with(std::vector<Entry> entries) {
  Results results;
  results.effort = "full";
  results.machine = {"0.1.0", "GCC", "Release", "processor", 2, "2026-01-01T00:00:00Z"};
  results.entries = std::move(entries);
  return results;
}

TEST(Compare, RatiosAreOfMediansAndTheLargestIsFirst) {
  const Comparison comparison =
      compare(results_with({measured("a", "ns", 100.0), measured("b", "ms", 2.0)}),
              results_with({measured("b", "ms", 3.0), measured("a", "ns", 80.0)}));
  ASSERT_EQ(comparison.ratios.size(), 2U);
  EXPECT_EQ(comparison.ratios[0].name, "kernels/call/b");
  EXPECT_DOUBLE_EQ(comparison.ratios[0].ratio, 1.5);
  EXPECT_DOUBLE_EQ(comparison.ratios[1].ratio, 0.8);
  EXPECT_TRUE(comparison.only_before.empty());
  EXPECT_TRUE(comparison.only_after.empty());
  EXPECT_TRUE(comparison.warnings.empty());
}

TEST(Compare, OnlyTimesAboveTheRatioAreSlower) {
  const Comparison comparison =
      compare(results_with({measured("time", "ns", 100.0), measured("memory", "MB", 10.0),
                            measured("same", "s", 4.0), measured("limit", "us", 100.0)}),
              results_with({measured("time", "ns", 111.0), measured("memory", "MB", 90.0),
                            measured("same", "s", 4.0), measured("limit", "us", 110.0)}));
  const std::vector<Ratio> slower = slower_than(comparison, 1.1);
  ASSERT_EQ(slower.size(), 1U);
  EXPECT_EQ(slower[0].name, "kernels/call/time");
  EXPECT_TRUE(slower_than(comparison, 1.2).empty());
  const std::string text = comparison_text(comparison, 1.1);
  EXPECT_NE(text.find("kernels/call/time  SLOWER"), std::string::npos) << text;
  EXPECT_NE(text.find("4 entries in both, 3 of them times, 1 slower"), std::string::npos) << text;
}

TEST(Compare, SaysWhatOnlyOneFileHas) {
  const Comparison comparison =
      compare(results_with({measured("a", "ns", 1.0), measured("old", "ns", 1.0)}),
              results_with({measured("a", "us", 1.0), measured("new", "ns", 1.0)}));
  EXPECT_TRUE(comparison.ratios.empty());  // a was measured in another unit
  EXPECT_EQ(comparison.only_before,
            (std::vector<std::string>{"kernels/call/a [ns]", "kernels/call/old [ns]"}));
  EXPECT_EQ(comparison.only_after,
            (std::vector<std::string>{"kernels/call/a [us]", "kernels/call/new [ns]"}));
  EXPECT_NE(comparison_text(comparison, 1.1).find("only in the second: kernels/call/new"),
            std::string::npos);
}

TEST(Compare, OfZeroIsNoNumberButAnAnswer) {
  const Comparison comparison =
      compare(results_with({measured("none", "%", 0.0), measured("some", "s", 0.0)}),
              results_with({measured("none", "%", 0.0), measured("some", "s", 1.0)}));
  EXPECT_TRUE(std::isinf(comparison.ratios[0].ratio));
  EXPECT_EQ(comparison.ratios[1].ratio, 1.0);
  EXPECT_EQ(slower_than(comparison, 1.1).size(), 1U);
}

TEST(Compare, WarnsOfOtherMachines) {
  const Results before = results_with({});
  Results after = before;
  after.machine.processor = "another";
  after.effort = "quick";
  EXPECT_EQ(compare(before, after).warnings,
            (std::vector<std::string>{"processor differs: processor, then another",
                                      "effort differs: full, then quick"}));
}

}  // namespace
}  // namespace prehend::bench
