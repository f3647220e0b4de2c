#include "sim/motion/contact_problem.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/motion/contact_violation.h"
#include "sim/motion/friction_cone.h"
#include "sim/motion/solve_contacts.h"
#include "tests/sim/motion/sample_problems.h"

namespace prehend {
namespace {

TEST(FrictionCone, ProjectionIsTheNearestPoint) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double mu = random.uniform(0.0, 2.0);
    ConeVector x = ConeVector::Zero();
    for (int k = 0; k < 3; ++k) x[k] = random.uniform(-1.0, 1.0);
    const ConeVector p = project_to_cone(x, mu).point;
    EXPECT_LE(p.tail<3>().norm(), mu * p[0] + 1e-15);
    // Moreau: what is cut off is orthogonal to the projection, and in the polar cone.
    const ConeVector q = x - p;
    EXPECT_NEAR(p.dot(q), 0.0, 1e-15);
    EXPECT_LE(q[0] + mu * q.tail<3>().norm(), 1e-15);
  }
}

// Without friction and slip, the cone is a ray, and what is behind its tip is not on it.
TEST(FrictionCone, WithoutFrictionNothingPulls) {
  EXPECT_TRUE(project_to_cone(-ConeVector::UnitX(), 0.0).point.isZero(0.0));
  EXPECT_TRUE(project_to_cone(-ConeVector::UnitX(), 0.0).derivative.isZero(0.0));
}

TEST(FrictionCone, DerivativeIsThatOfTheProjection) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const double mu = random.uniform(0.1, 2.0);
    ConeVector x;
    ConeVector d;
    for (double& value : x) value = random.uniform(-1.0, 1.0);
    for (double& value : d) value = random.uniform(-1.0, 1.0);
    constexpr double h = 1e-6;
    const ConeVector ahead = project_to_cone(ConeVector(x + h * d), mu).point;
    const ConeVector behind = project_to_cone(ConeVector(x - h * d), mu).point;
    const ConeVector slope = (ahead - behind) / (2.0 * h);
    EXPECT_LT((slope - project_to_cone(x, mu).derivative * d).norm(), 1e-5);
  }
}

// Pushed sideways by more than friction holds: Coulomb's law in closed form, with the box free to
// tip, which it does not.
TEST(ContactProblem, ABoxSlidesByWhatFrictionLeaves) {
  for (const double mu : {0.1, 0.5, 1.0, 1.8}) {
    Vector6 free = Vector6::Zero();
    free.tail<3>() = Vector3(3.0, 0.0, -0.4);
    const double slow = mu * 0.4;
    // The moment of friction about the centre must not lift the box: keep its push small.
    const ContactSolution solution = solve_contacts(test::box_on_plane(mu, free));
    EXPECT_EQ(solution.outcome, ContactOutcome::solved) << mu << " " << solution.violation;
    if (mu * 0.03 > 0.1) continue;
    EXPECT_NEAR(solution.velocity[3], 3.0 - slow, 1e-9) << mu;
    EXPECT_NEAR(solution.velocity[5], 0.0, 1e-9) << mu;
    EXPECT_LT(solution.velocity.head<3>().norm(), 1e-8) << mu;
  }
}

TEST(ContactProblem, ABoxSticksInsideTheCone) {
  Vector6 free = Vector6::Zero();
  free.tail<3>() = Vector3(0.03, 0.02, -0.4);
  free.head<3>() = Vector3(0.0, 0.0, 0.1);
  const ContactSolution solution = solve_contacts(test::box_on_plane(0.5, free));
  EXPECT_EQ(solution.outcome, ContactOutcome::solved);
  EXPECT_LT(solution.velocity.norm(), 1e-10);
}

TEST(ContactProblem, WhatMovesAwayFeelsNothing) {
  Vector6 free = Vector6::Zero();
  free.tail<3>() = Vector3(1.0, 0.0, 0.2);
  const ContactSolution solution = solve_contacts(test::box_on_plane(0.5, free));
  EXPECT_EQ(solution.outcome, ContactOutcome::solved);
  EXPECT_LT((solution.velocity - free).norm(), 1e-14);
  for (const Eigen::Vector4d& impulse : solution.impulses) EXPECT_LT(impulse.norm(), 1e-14);
}

TEST(ContactProblem, AGapMayCloseInOneStep) {
  Vector6 free = Vector6::Zero();
  free[5] = -1.0;
  ContactProblem problem = test::box_on_plane(0.5, free);
  for (ContactCondition& contact : problem.contacts) contact.offset[0] = 0.25;
  const ContactSolution solution = solve_contacts(problem);
  EXPECT_EQ(solution.outcome, ContactOutcome::solved);
  EXPECT_NEAR(solution.velocity[5], -0.25, 1e-10);
}

// A pile of bodies with random contacts between them and with the ground, rubber among them: the
// law holds at every contact, and momentum is conserved.
TEST(ContactProblem, RandomPilesFollowTheLaw) {
  Random random(7);
  int unsolved = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const ContactProblem problem = test::random_pile(random);
    const ContactSolution solution = solve_contacts(
        problem, {.tolerance = 1e-10, .acceptable = 1e-10, .max_rounds = 200, .max_newton = 50});
    if (solution.outcome != ContactOutcome::solved) {
      ++unsolved;
      continue;
    }
    EXPECT_LE(contact_violation(problem, solution.velocity, solution.impulses), 1e-10);
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(problem.free.size());
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
      for (const JacobianBlock& block : problem.contacts[i].blocks) {
        momentum.segment(block.first, 6) += block.transposed * solution.impulses[i];
      }
    }
    for (const ContactProblem::Mass& mass : problem.masses) {
      momentum.segment(mass.first, 6) -=
          mass.matrix * (solution.velocity - problem.free).segment(mass.first, 6);
    }
    EXPECT_LT(momentum.norm(), 1e-9);
  }
  EXPECT_EQ(unsolved, 0);
}

}  // namespace
}  // namespace prehend
