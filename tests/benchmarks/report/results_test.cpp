#include "benchmarks/report/results.h"

#include <gtest/gtest.h>

#include "benchmarks/support/percentile.h"

namespace prehend::bench {
namespace {

TEST(Percentile, IsInterpolatedBetweenValues) {
  using benchmark::percentile;
  EXPECT_EQ(percentile({}, 0.5), 0.0);
  EXPECT_EQ(percentile({7.0}, 0.99), 7.0);
  EXPECT_DOUBLE_EQ(percentile({4.0, 1.0, 3.0, 2.0}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(percentile({5.0, 1.0, 3.0}, 0.5), 3.0);
  std::vector<double> hundred;
  for (int i = 0; i <= 100; ++i) hundred.push_back(100.0 - i);
  EXPECT_DOUBLE_EQ(percentile(hundred, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(percentile(hundred, 0.9), 90.0);
  EXPECT_NEAR(percentile(hundred, 0.995), 99.5, 1e-9);
  EXPECT_DOUBLE_EQ(percentile(hundred, 1.0), 100.0);
}

TEST(Results, SummaryOfNothingIsZero) {
  const Summary summary = summarize({});
  EXPECT_EQ(summary.samples, 0);
  EXPECT_EQ(summary.median, 0.0);
  EXPECT_EQ(summary.most, 0.0);
}

TEST(Results, SummaryIsOrdered) {
  const Summary summary = summarize({9.0, 1.0, 5.0, 3.0, 7.0});
  EXPECT_EQ(summary.samples, 5);
  EXPECT_EQ(summary.least, 1.0);
  EXPECT_DOUBLE_EQ(summary.p10, 1.8);
  EXPECT_EQ(summary.median, 5.0);
  EXPECT_DOUBLE_EQ(summary.p90, 8.2);
  EXPECT_DOUBLE_EQ(summary.p99, 8.92);
  EXPECT_EQ(summary.most, 9.0);
  EXPECT_NEAR(summary.mean, 5.0, 1e-12);
}

TEST(Results, NamesTellSizesApart) {
  Entry entry{"scaling", "triangles", "trial", 1e6, "ms", {}};
  EXPECT_EQ(name_of(entry), "scaling/triangles/trial/1000000");
  entry.x.reset();
  EXPECT_EQ(name_of(entry), "scaling/triangles/trial");
}

TEST(Results, EntriesAreFoundByGroupAndName) {
  Results results;
  results.entries = {{"kernels", "call", "a", {}, "ns", {}},
                     {"scaling", "contacts", "b", 3.0, "ms", {}},
                     {"kernels", "call", "c", {}, "ns", {}}};
  const std::vector<Entry> calls = entries_of(results, "kernels", "call");
  ASSERT_EQ(calls.size(), 2U);
  EXPECT_EQ(calls[1].series, "c");
  EXPECT_EQ(find_entry(results, "scaling/contacts/b/3"), &results.entries[1]);
  EXPECT_EQ(find_entry(results, "scaling/contacts/b"), nullptr);
}

}  // namespace
}  // namespace prehend::bench
