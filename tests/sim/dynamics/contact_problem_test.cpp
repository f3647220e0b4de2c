#include "sim/dynamics/contact_problem.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/dynamics/friction_cone.h"
#include "sim/dynamics/spatial.h"

namespace prehend {
namespace {

// A contact of body `first` with what stands still, at p from its centre, along the normal.
JacobianBlock touching(int first, const Vector3& p, const Vector3& normal, double sign = 1.0) {
  const Vector3 t1 = any_orthogonal(normal);
  const Vector3 t2 = normal.cross(t1);
  JacobianBlock block{first, Eigen::MatrixXd::Zero(3, 6)};
  int row = 0;
  for (const Vector3& direction : {normal, t1, t2}) {
    block.rows.block<1, 3>(row, 0) = sign * p.cross(direction).transpose();
    block.rows.block<1, 3>(row, 3) = sign * direction.transpose();
    ++row;
  }
  return block;
}

// A box of edges `size` about its centre: velocities are angular, then linear.
ContactProblem::Mass box_mass(int first, double mass, const Vector3& size) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(6, 6) * mass;
  const Vector3 s = size.cwiseProduct(size);
  matrix.topLeftCorner<3, 3>() =
      (mass / 12.0 * Vector3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())).asDiagonal();
  return {first, matrix};
}

// A box on a plane, on its four lower corners.
ContactProblem box_on_plane(double friction, const Vector6& free) {
  const Vector3 size(0.2, 0.1, 0.06);
  ContactProblem problem{{box_mass(0, 1.5, size)}, free, {}};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      problem.contacts.push_back(
          {{touching(0, Vector3(x, y, -0.5).cwiseProduct(size), Vector3::UnitZ())}, friction});
    }
  }
  return problem;
}

TEST(FrictionCone, ProjectionIsTheNearestPoint) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double mu = random.uniform(0.0, 2.0);
    ConeVector x(3);
    for (double& value : x) value = random.uniform(-1.0, 1.0);
    const ConeVector p = project_to_cone(x, mu).point;
    EXPECT_LE(p.tail(2).norm(), mu * p[0] + 1e-15);
    // Moreau: what is cut off is orthogonal to the projection, and in the polar cone.
    const ConeVector q = x - p;
    EXPECT_NEAR(p.dot(q), 0.0, 1e-15);
    EXPECT_LE(q[0] + mu * q.tail(2).norm(), 1e-15);
  }
}

TEST(FrictionCone, DerivativeIsThatOfTheProjection) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const double mu = random.uniform(0.1, 2.0);
    ConeVector x(4);
    ConeVector d(4);
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
    const ContactSolution solution = solve_contacts(box_on_plane(mu, free));
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
  const ContactSolution solution = solve_contacts(box_on_plane(0.5, free));
  EXPECT_EQ(solution.outcome, ContactOutcome::solved);
  EXPECT_LT(solution.velocity.norm(), 1e-10);
}

TEST(ContactProblem, WhatMovesAwayFeelsNothing) {
  Vector6 free = Vector6::Zero();
  free.tail<3>() = Vector3(1.0, 0.0, 0.2);
  const ContactSolution solution = solve_contacts(box_on_plane(0.5, free));
  EXPECT_EQ(solution.outcome, ContactOutcome::solved);
  EXPECT_LT((solution.velocity - free).norm(), 1e-14);
  for (const Eigen::Vector4d& impulse : solution.impulses) EXPECT_LT(impulse.norm(), 1e-14);
}

TEST(ContactProblem, AGapMayCloseInOneStep) {
  Vector6 free = Vector6::Zero();
  free[5] = -1.0;
  ContactProblem problem = box_on_plane(0.5, free);
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
    const int bodies = 1 + static_cast<int>(random.uniform(0.0, 6.0));
    ContactProblem problem;
    problem.free = Eigen::VectorXd::Zero(6 * bodies);
    for (int b = 0; b < bodies; ++b) {
      problem.masses.push_back(
          box_mass(6 * b, std::pow(10.0, random.uniform(-1.5, 1.0)), {0.1, 0.2, 0.15}));
      for (int k = 0; k < 6; ++k) problem.free[6 * b + k] = random.uniform(-1.0, 1.0);
    }
    const int contacts = 1 + static_cast<int>(random.uniform(0.0, 20.0));
    for (int c = 0; c < contacts; ++c) {
      const int body = static_cast<int>(random.uniform(0.0, bodies));
      const int other = static_cast<int>(random.uniform(-1.0, bodies));
      const auto place = [&] {
        return Vector3(random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1),
                       random.uniform(-0.1, 0.1));
      };
      const Vector3 normal = (10.0 * place()).normalized();
      ContactCondition contact{{touching(6 * body, place(), normal)}, random.uniform(0.0, 1.5)};
      if (other >= 0 && other != body) {
        contact.blocks.push_back(touching(6 * other, place(), normal, -1.0));
      }
      contact.offset[0] = random.uniform(0.0, 0.1);
      problem.contacts.push_back(contact);
    }
    const ContactSolution solution = solve_contacts(
        problem, {.tolerance = 1e-10, .acceptable = 1e-10, .max_rounds = 200, .max_newton = 50});
    if (solution.outcome != ContactOutcome::solved) {
      ++unsolved;
      continue;
    }
    EXPECT_LE(contact_violation(problem, solution.velocity, solution.impulses), 1e-10);
    Eigen::VectorXd momentum = Eigen::VectorXd::Zero(6 * bodies);
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
      for (const JacobianBlock& block : problem.contacts[i].blocks) {
        momentum.segment(block.first, 6) += block.rows.transpose() * solution.impulses[i].head(3);
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
