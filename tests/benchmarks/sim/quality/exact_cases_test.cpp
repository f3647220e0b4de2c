#include "benchmarks/sim/quality/exact_cases.h"

#include <gtest/gtest.h>

#include "tests/support/degenerate_grasps.h"
#include "tests/support/repeats.h"

namespace prehend::test {
namespace {

TEST(ExactCases, QualityIsRightAboutEachDegenerateKind) {
  const std::vector<ExactTally> tallies = exact_cases(repeats(3), 7);
  EXPECT_EQ(tallies.size(), kDegenerateKinds.size());
  int closed = 0;
  int cases = 0;
  for (const ExactTally& tally : tallies) {
    for (const std::string& fault : tally.faults) ADD_FAILURE() << tally.kind << ": " << fault;
    EXPECT_EQ(tally.cases, repeats(3)) << tally.kind;
    closed += tally.closed;
    cases += tally.cases;
  }
  // Both answers occur.
  EXPECT_GT(closed, cases / 5);
  EXPECT_LT(closed, cases * 4 / 5);
}

}  // namespace
}  // namespace prehend::test
