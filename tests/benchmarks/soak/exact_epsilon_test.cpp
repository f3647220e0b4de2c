// Exact epsilon against closed forms, and the wrenches that are judged against the library's.
#include <cmath>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/extreme_grasps.h"
#include "tests/support/grasp_families.h"
#include "tests/support/judge_epsilon.h"

namespace prehend::test {
namespace {

// The cross-polytope with corners at distance r on all axes has its facets at r / sqrt(6).
exact::Columns cross_polytope(double r) {
  exact::Columns columns(6, 12);
  columns << r * Eigen::Matrix<double, 6, 6>::Identity(),
      -r * Eigen::Matrix<double, 6, 6>::Identity();
  return columns;
}

TEST(ExactEpsilon, OfTheCrossPolytope) {
  for (const double r : {1e-3, 1.0, 12.5}) {
    const exact::Epsilon answer = exact::epsilon(cross_polytope(r), {.whole = 12});
    EXPECT_TRUE(answer.force_closure);
    EXPECT_EQ(answer.facets, 64U);
    EXPECT_EQ(answer.lower, answer.upper);
    EXPECT_EQ(answer.lower, exact::epsilon(cross_polytope(r)).lower);
    EXPECT_NEAR(answer.lower.convert_to<double>(), r / std::sqrt(6.0), 1e-15 * r);
  }
}

TEST(ExactEpsilon, OfASetThatDoesNotReachAround) {
  exact::Columns columns = cross_polytope(1.0);
  columns.row(5) = columns.row(5).cwiseAbs();
  EXPECT_FALSE(exact::epsilon(columns).force_closure);
  columns.row(5).setZero();
  EXPECT_EQ(exact::epsilon(columns).dimension, 5);
  columns.row(5)(0) = 1e-300;
  EXPECT_EQ(exact::epsilon(columns).dimension, 6);
}

// Bounds that stop at a limit of facets hold what all facets give between them.
TEST(ExactEpsilon, BoundsHoldTheValue) {
  const exact::Columns wrenches = judged_wrenches(cube_grasp(0.5), {}, 12);
  const exact::Epsilon all = exact::epsilon(wrenches);
  const exact::Epsilon few = exact::epsilon(wrenches, {.most_facets = 100});
  EXPECT_EQ(all.lower, all.upper);
  EXPECT_LE(few.lower, all.lower);
  EXPECT_GE(few.upper, all.lower);
  EXPECT_LT(few.lower, few.upper);
}

// The table of tests/sim/quality/oracle/extremes.md came from the same hull with other integers.
TEST(ExactEpsilon, OfExtremeGraspsIsThatOfTheTable) {
  const auto table = nlohmann::json::parse(
      std::ifstream(PREHEND_SOURCE_DIR "/tests/sim/quality/oracle/extremes.json"));
  int compared = 0;
  for (const nlohmann::json& row : table) {
    if (row["points"].get<int>() > 40 || row["facets"].get<int>() > 1000) continue;
    for (const ExtremeGrasp& grasp : extreme_grasps()) {
      if (grasp.name != row["name"]) continue;
      const Wrenches wrenches = contact_wrenches(grasp.contacts, grasp.frame, grasp.edges);
      const exact::Epsilon answer = exact::epsilon(wrenches);
      EXPECT_EQ(answer.dimension, row["dimension"].get<int>()) << grasp.name;
      EXPECT_EQ(answer.force_closure, row["force_closure"].get<bool>()) << grasp.name;
      const double expected = std::stod(row["epsilon"].get<std::string>());
      EXPECT_NEAR(answer.lower.convert_to<double>(), expected, 1e-15 * expected) << grasp.name;
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
}

EpsilonBracket claim(double lower, double upper) {
  EpsilonBracket bracket;
  bracket.lower = lower;
  bracket.upper = upper;
  if (lower > 0.0) bracket.status = EpsilonStatus::converged;
  return bracket;
}

TEST(JudgedEpsilon, IsWhatItMustBe) {
  const exact::Columns set = cross_polytope(1.0);
  const double value = 1.0 / std::sqrt(6.0);
  EXPECT_EQ(judge_epsilon(claim(value, value), set, 1000).fault, "");
  EXPECT_NE(judge_epsilon(claim(value, value * (1.0 + 1e-8)), set, 1000).fault, "") << "too wide";
  EXPECT_NE(judge_epsilon(claim(value + 1e-9, value + 1e-9), set, 1000).fault, "");
  EXPECT_NE(judge_epsilon(claim(value - 1e-9, value - 1e-9), set, 1000).fault, "");
  EXPECT_NE(judge_epsilon(claim(0.0, 0.0), set, 1000).fault, "");
  exact::Columns half = set;
  half.row(5) = half.row(5).cwiseAbs();
  EXPECT_EQ(judge_epsilon(claim(0.0, 0.0), half, 1000).fault, "");
  EXPECT_NE(judge_epsilon(claim(1e-3, 1e-3), half, 1000).fault, "");
  // Thinner than 1e-9 of its size: none by definition.
  exact::Columns thin = set;
  thin.row(5) *= 1e-10;
  EXPECT_EQ(judge_epsilon(claim(0.0, 0.0), thin, 1000).fault, "");
  EXPECT_NE(judge_epsilon(claim(1e-10, 1e-10), thin, 1000).fault, "");
}

TEST(JudgedWrenches, AreThoseOfTheLibrary) {
  for (NamedGrasp& grasp : grasp_families(5, 2)) {
    for (std::size_t i = 0; i < grasp.contacts.size(); i += 2) {
      grasp.contacts[i].model = i % 4 == 0 ? ContactModel::soft_finger : ContactModel::frictionless;
      grasp.contacts[i].torsion = 0.1;
      grasp.contacts[i].normal *= 1.0 + 1e-9;
    }
    const TorqueFrame frame{{0.1, 0.2, -0.3}, 2.5};
    const exact::Columns own = judged_wrenches(grasp.contacts, frame, grasp.edges);
    const Wrenches wrenches =
        contact_wrenches(grasp.contacts, {frame.origin, frame.scale}, grasp.edges);
    ASSERT_EQ(own.cols(), wrenches.cols()) << grasp.name;
    EXPECT_LT((own - wrenches).cwiseAbs().maxCoeff(), 1e-14) << grasp.name;
  }
}

}  // namespace
}  // namespace prehend::test
