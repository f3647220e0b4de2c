#include "benchmarks/shake/disagreements.h"

#include <gtest/gtest.h>

namespace prehend::bench {
namespace {

Counterfactual change(const std::string& cause, bool in_ours, std::optional<bool> survives) {
  return {cause, in_ours, [survives] { return survives; }};
}

// Ours holds and MuJoCo's does not: ours has to lose the grasp, or MuJoCo's to hold it.
TEST(Disagreements, TheFirstChangeAfterWhichBothAgreeIsTheCause) {
  const std::vector<Counterfactual> changes = {
      change("still held by ours", true, true), change("still lost by theirs", false, false),
      change("not possible", true, std::nullopt), change("theirs holds", false, true),
      change("ours loses", true, false)};
  EXPECT_EQ(first_cause(changes, true, false), "theirs holds");
}

TEST(Disagreements, TheOtherWayRound) {
  const std::vector<Counterfactual> changes = {change("ours still loses", true, false),
                                               change("theirs loses", false, false)};
  EXPECT_EQ(first_cause(changes, false, true), "theirs loses");
}

TEST(Disagreements, WhatNoChangeFlipsHasNoCause) {
  EXPECT_EQ(first_cause({change("held", true, true), change("lost", false, false)}, true, false),
            std::nullopt);
  EXPECT_EQ(first_cause({}, true, false), std::nullopt);
}

ShakeTestResult test_that(const std::string& name, PhaseFailure failure) {
  return {name, {{PhaseKind::hold, {}, failure}}};
}

TEST(Disagreements, AVerdictNamesTheTestsThatFailed) {
  ShakeResult result;
  result.tests = {test_that("gravity", PhaseFailure::none), test_that("+x", PhaseFailure::moved),
                  test_that("-x", PhaseFailure::moved), test_that("+y", PhaseFailure::turned)};
  EXPECT_EQ(verdict_text(result), "moved in +x, -x, turned in +y");
  result.tests.resize(1);
  EXPECT_EQ(verdict_text(result), "survived");
  result.prepare = test_that("prepare", PhaseFailure::unstable);
  EXPECT_EQ(verdict_text(result), "unstable in prepare");
}

}  // namespace
}  // namespace prehend::bench
