#include "sim/soft/press.h"

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

PressProblem random_problem(Random& random, Eigen::Index n) {
  PressProblem problem;
  Eigen::MatrixXd factor(n, n);
  problem.gap.resize(n);
  problem.weight.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) factor(i, k) = random.uniform(-1.0, 1.0);
    problem.gap[i] = random.uniform(0.0, 1.0);
    problem.weight[i] = random.uniform(0.2, 1.0);
  }
  problem.compliance = factor * factor.transpose() + 0.01 * Eigen::MatrixXd::Identity(n, n);
  return problem;
}

void expect_contact(const PressProblem& problem, const NodeForces& forces) {
  const Eigen::VectorXd gap =
      problem.gap - forces.approach * problem.weight + problem.compliance * forces.force;
  const double size = std::max(1.0, std::abs(forces.approach));
  for (Eigen::Index i = 0; i < gap.size(); ++i) {
    EXPECT_GE(forces.force[i], 0.0);
    EXPECT_GE(gap[i], -1e-8 * size);
    EXPECT_LT(std::min(forces.force[i], gap[i]), 1e-8 * size);
  }
  EXPECT_NEAR(problem.weight.dot(forces.force), forces.load, 1e-9 * (1.0 + forces.load));
}

TEST(Press, ObeysTheConditionsOfContactOnRandomSurfaces) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const PressProblem problem = random_problem(random, 1 + random.integer(0, 19));
    expect_contact(problem, press_by(problem, random.uniform(0.0, 5.0)));
    const double load = std::pow(10.0, random.uniform(-3.0, 3.0));
    const NodeForces forces = press_with(problem, load, 1e9);
    expect_contact(problem, forces);
    EXPECT_NEAR(forces.load, load, 1e-6 * load);
  }
}

TEST(Press, EndsAtTheFarthestApproachWithLessLoad) {
  Random random(4);
  const PressProblem problem = random_problem(random, 8);
  const NodeForces full = press_with(problem, 10.0, 1e9);
  const NodeForces part = press_with(problem, 10.0, 0.5 * full.approach);
  EXPECT_EQ(part.approach, 0.5 * full.approach);
  EXPECT_LT(part.load, 10.0);
  expect_contact(problem, part);
}

TEST(Press, BearsNothingBeforeItTouches) {
  Random random(5);
  PressProblem problem = random_problem(random, 5);
  problem.gap.array() += 1.0;
  const NodeForces forces = press_by(problem, 0.5);
  EXPECT_EQ(forces.load, 0.0);
  EXPECT_TRUE((forces.force.array() == 0.0).all());
}

}  // namespace
}  // namespace prehend
