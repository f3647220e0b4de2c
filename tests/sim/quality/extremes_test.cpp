// Grasps at the ends of what numbers can say, against exact arithmetic (oracle/README.md).
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/quality/epsilon.h"
#include "sim/quality/start_simplex.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/extreme_grasps.h"
#include "tests/support/refused_grasps.h"

namespace prehend::test {
namespace {

using nlohmann::json;

constexpr const char* kRoot = PREHEND_SOURCE_DIR;

// What exact arithmetic says of a grasp's wrenches.
struct Exact {
  bool force_closure = false;
  double lower = 0.0;
  double upper = 0.0;
};

std::map<std::string, Exact> read_oracle() {
  std::ifstream stream(std::string(kRoot) + "/tests/sim/quality/oracle/extremes.json");
  std::map<std::string, Exact> oracle;
  for (const json& entry : json::parse(stream)) {
    oracle[entry.at("name")] = {entry.at("force_closure").get<bool>(),
                                std::stod(entry.at("epsilon").get<std::string>()),
                                std::stod(entry.at("upper").get<std::string>())};
  }
  return oracle;
}

double size(const Wrenches& wrenches) {
  return wrenches.cols() == 0 ? 0.0 : wrenches.cwiseAbs().maxCoeff();
}

// What a bracket may miss the exact value by. The bracket's own promise is 2e-14 of the set's size.
// Columns differ in their last digits between platforms, and epsilon moves by no more than the
// column that moves most; 1e-13 of the size covers both, the sines being good to 2e-16.
double rounding(const Wrenches& wrenches) { return 1e-13 * size(wrenches); }

struct Case {
  std::string name;
  Wrenches wrenches;
  EpsilonBracket bracket;
  Exact exact;
};

class Extremes : public testing::Test {
 protected:
  // Once for all tests: a grasp of a thousand contacts takes a while.
  static const std::vector<Case>& cases() {
    static const std::vector<Case> all = [] {
      const std::map<std::string, Exact> oracle = read_oracle();
      std::vector<Case> made;
      for (const ExtremeGrasp& grasp : extreme_grasps()) {
        const Wrenches wrenches = contact_wrenches(grasp.contacts, grasp.frame, grasp.edges);
        made.push_back({grasp.name, wrenches, epsilon_l1(wrenches), oracle.at(grasp.name)});
      }
      return made;
    }();
    return all;
  }
};

TEST_F(Extremes, NothingIsNotANumber) {
  for (const auto& [name, wrenches, bracket, exact] : cases()) {
    EXPECT_TRUE(wrenches.allFinite()) << name;
    EXPECT_TRUE(std::isfinite(bracket.lower)) << name;
    EXPECT_TRUE(std::isfinite(bracket.upper)) << name;
    EXPECT_TRUE(bracket.weakest.allFinite()) << name;
    EXPECT_GE(bracket.lower, 0.0) << name;
    EXPECT_LE(bracket.lower, bracket.upper) << name;
  }
}

// Thinner than kFlatness is no force closure by definition; no case is near that limit.
TEST_F(Extremes, ForceClosureIsThatOfExactArithmeticDownToTheFlatnessLimit) {
  for (const auto& [name, wrenches, bracket, exact] : cases()) {
    const double limit = kFlatness * size(wrenches);
    ASSERT_FALSE(exact.lower > 0.9 * limit && exact.lower < 1.1 * limit) << name;
    EXPECT_EQ(bracket.force_closure(), exact.lower > limit) << name;
    EXPECT_TRUE(exact.force_closure || !bracket.force_closure()) << name;
    EXPECT_EQ(bracket.force_closure(), bracket.lower > 0.0) << name;
    EXPECT_EQ(bracket.status == EpsilonStatus::no_force_closure, !bracket.force_closure()) << name;
  }
}

TEST_F(Extremes, BracketHoldsTheExactValue) {
  for (const auto& [name, wrenches, bracket, exact] : cases()) {
    if (!bracket.force_closure()) {
      EXPECT_EQ(bracket.upper, 0.0) << name;
      EXPECT_EQ(bracket.weakest, Wrench::Zero()) << name;
      continue;
    }
    EXPECT_LE(bracket.lower, exact.upper + rounding(wrenches)) << name;
    EXPECT_GE(bracket.upper, exact.lower - rounding(wrenches)) << name;
    if (bracket.status == EpsilonStatus::limit) continue;
    EXPECT_EQ(bracket.status, EpsilonStatus::converged) << name;
    // The default tolerance, of the upper bound.
    EXPECT_LE(bracket.upper - bracket.lower, 1e-9 * bracket.upper + rounding(wrenches)) << name;
  }
}

// The wrench that the grasp resists least: nothing answers it with more than epsilon.
TEST_F(Extremes, WeakestIsAnsweredByTheUpperBound) {
  for (const auto& [name, wrenches, bracket, exact] : cases()) {
    if (!bracket.force_closure()) continue;
    const Wrench direction = -bracket.weakest / bracket.upper;
    EXPECT_NEAR(direction.norm(), 1.0, 1e-12) << name;
    EXPECT_NEAR((direction.transpose() * wrenches).maxCoeff(), bracket.upper,
                1e-9 * bracket.upper + rounding(wrenches))
        << name;
  }
}

TEST_F(Extremes, FullHullAgrees) {
  for (const auto& [name, wrenches, bracket, exact] : cases()) {
    if (wrenches.cols() > 64) continue;  // the hull of thousands of wrenches takes minutes
    const WrenchHull hull = wrench_hull(wrenches);
    EXPECT_FALSE(std::isnan(hull.min_offset)) << name;
    EXPECT_FALSE(std::isnan(hull.volume)) << name;
    EXPECT_TRUE(hull.weakest.allFinite()) << name;
    EXPECT_EQ(hull.force_closure(), exact.lower > kFlatness * size(wrenches)) << name;
    if (!hull.force_closure()) continue;
    // A joggled hull, of near-duplicates, is good to its joggle only.
    const bool joggled = hull.doubt > 1.01 * kFlatness * size(wrenches);
    EXPECT_NEAR(hull.min_offset, exact.lower,
                1e-9 * exact.lower + rounding(wrenches) + (joggled ? hull.doubt : 0.0))
        << name;
  }
}

TEST(Refused, WithAMessage) {
  for (const RefusedGrasp& grasp : refused_grasps()) {
    EXPECT_EQ(refusal(grasp), grasp.message) << grasp.name;
  }
}

TEST(ExtremesTable, MentionsEveryGraspOnce) {
  std::ifstream stream(std::string(kRoot) + "/tests/sim/quality/oracle/extremes.md");
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  std::set<std::string> names;
  for (const ExtremeGrasp& grasp : extreme_grasps()) {
    EXPECT_TRUE(names.insert(grasp.name).second) << grasp.name;
    EXPECT_NE(text.find("\n| " + grasp.name + " |"), std::string::npos) << grasp.name;
  }
  for (const RefusedGrasp& grasp : refused_grasps()) {
    EXPECT_NE(text.find("\n| " + grasp.name + " | `" + grasp.message + "` |"), std::string::npos)
        << grasp.name;
  }
}

}  // namespace
}  // namespace prehend::test
