// The probability of success against closed forms, and what it may never do.
#include "sim/trial/success.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

TEST(Success, IsALogisticRegressionTimesTheShareThatCloses) {
  const SuccessModel model{.intercept = -1.0, .weights = {2.0, 3.0, 0.5, 0.25, 1.5, 0.1, 0.7}};
  SuccessFacts facts{.closed = 0.75, .held = 0.5, .epsilon = 0.1, .strength = 30.0};
  const double z = -1.0 + 2.0 * 0.25 + 3.0 * 0.5 + 0.5 * 0.75;
  EXPECT_NEAR(success_probability(facts, model), 0.75 / (1.0 + std::exp(-z)), 1e-15);
  facts.free = FreeEnd{.kept = true, .epsilon = 0.3, .strength = 10.0, .moved = 0.015};
  const double free = 0.25 + 1.5 * 0.75 + 0.1 * 0.5 + 0.7 * std::exp(-0.5);
  EXPECT_NEAR(success_probability(facts, model), 0.75 / (1.0 + std::exp(-z - free)), 1e-15);
  facts.free->kept = false;
  EXPECT_NEAR(success_probability(facts, model), 0.75 / (1.0 + std::exp(-z)), 1e-15);
}

TEST(Success, FactsAreThoseOfTheTrials) {
  Robustness robustness;
  robustness.samples = 16;
  robustness.held = 4;
  robustness.epsilon_mean = 0.125;
  robustness.strength = 2.5;
  robustness.outcomes[Outcome::stable] = 7;
  robustness.outcomes[Outcome::not_force_closure] = 5;
  robustness.outcomes[Outcome::hand_blocked] = 4;
  const SuccessFacts facts = success_facts(robustness);
  EXPECT_EQ(facts.closed, 0.75);
  EXPECT_EQ(facts.held, 0.25);
  EXPECT_EQ(facts.epsilon, 0.125);
  EXPECT_EQ(facts.strength, 2.5);
  EXPECT_EQ(success_facts(Robustness{}).closed, 0.0);
}

SuccessFacts random_facts(Random& random) {
  return {random.uniform(0.0, 1.0), random.uniform(0.0, 1.0), std::exp(random.uniform(-12.0, 0.0)),
          std::exp(random.uniform(-5.0, 8.0))};
}

TEST(Success, NeverFallsWhenAFactGrows) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const SuccessModel model = shipped_success_model(i % 2 == 0);
    const SuccessFacts facts = random_facts(random);
    const double before = success_probability(facts, model);
    EXPECT_GE(before, 0.0);
    EXPECT_LE(before, 1.0);
    for (double SuccessFacts::*fact : {&SuccessFacts::closed, &SuccessFacts::held,
                                       &SuccessFacts::epsilon, &SuccessFacts::strength}) {
      SuccessFacts more = facts;
      more.*fact *= random.uniform(1.0, 2.0);
      EXPECT_GE(success_probability(more, model), before);
    }
  }
}

// An object that is kept, held better where it ended, and has moved less.
TEST(Success, NeverFallsWhenAFreeObjectFaresBetter) {
  Random random(4);
  const SuccessModel model = shipped_success_model(true);
  for (int i = 0; i < 2000; ++i) {
    SuccessFacts facts = random_facts(random);
    facts.free = FreeEnd{};
    const double lost = success_probability(facts, model);
    facts.free = FreeEnd{true, std::exp(random.uniform(-12.0, 0.0)),
                         std::exp(random.uniform(-5.0, 8.0)), random.uniform(0.0, 0.2)};
    const double kept = success_probability(facts, model);
    EXPECT_GE(kept, lost);
    SuccessFacts better = facts;
    better.free->epsilon *= random.uniform(1.0, 2.0);
    better.free->strength *= random.uniform(1.0, 2.0);
    better.free->moved *= random.uniform(0.0, 1.0);
    EXPECT_GE(success_probability(better, model), kept);
  }
}

TEST(Success, ExtremesAreNumbers) {
  const SuccessModel model = shipped_success_model(false);
  EXPECT_EQ(success_probability(SuccessFacts{}, model), 0.0);
  const double any = std::numeric_limits<double>::infinity();
  const double best = success_probability({1.0, 1.0, 1.0, any}, model);
  EXPECT_GT(best, success_probability({1.0, 1.0, 1.0, 1e3}, model) - 1e-12);
  EXPECT_LE(best, 1.0);
}

}  // namespace
}  // namespace prehend
