#include "sim/motion/contact_pyramids.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/motion/contact_violation.h"
#include "sim/motion/solve_contacts.h"
#include "tests/sim/motion/sample_problems.h"

namespace prehend {
namespace {

// Along an edge of the pyramid friction is that of the cone.
TEST(ContactPyramids, ABoxSlidesAlongAnEdgeAsOnACone) {
  const Vector3 normal = Vector3::UnitZ();
  const Vector3 edge = any_orthogonal(normal);
  for (const double mu : {0.1, 0.5, 1.0}) {
    Vector6 free = Vector6::Zero();
    free.tail<3>() = 3.0 * edge - 0.4 * normal;
    const ContactSolution solution = solve_with_pyramids(test::box_on_plane(mu, free));
    ASSERT_EQ(solution.outcome, ContactOutcome::solved) << mu;
    EXPECT_LT((solution.velocity.tail<3>() - (3.0 - mu * 0.4) * edge).norm(), 1e-12) << mu;
    EXPECT_LT(solution.velocity.head<3>().norm(), 1e-11) << mu;
  }
}

// Between two edges the impulse may be anywhere on the side of the pyramid: 8 edges lack 7.6 %
// there.
TEST(ContactPyramids, FrictionIsWeakerBetweenEdges) {
  constexpr double kAngle = 3.14159265358979 / 8.0;
  const Vector3 normal = Vector3::UnitZ();
  const Vector3 edge = any_orthogonal(normal);
  Vector6 free = Vector6::Zero();
  free.tail<3>() =
      3.0 * (std::cos(kAngle) * edge + std::sin(kAngle) * normal.cross(edge)) - 0.4 * normal;
  const ContactSolution solution = solve_with_pyramids(test::box_on_plane(0.5, free));
  ASSERT_EQ(solution.outcome, ContactOutcome::solved);
  // Coulomb's law bounds friction along the way that it went.
  const Vector3 slid = solution.velocity.tail<3>();
  const double along = (free.tail<3>() - slid).dot(slid.normalized());
  EXPECT_GE(along, 0.5 * 0.4 * std::cos(kAngle) - 1e-12);
  EXPECT_LE(along, 0.5 * 0.4 + 1e-12);
}

// The impulses of a pile follow the law of cones the better the more edges there are: the error of
// the pyramid falls with the square of their number.
TEST(ContactPyramids, ManyEdgesAreACone) {
  Random random(7);
  for (int trial = 0; trial < 12; ++trial) {
    const ContactProblem problem = test::random_pile(random);
    for (const int edges : {8, 32}) {
      const ContactSolution solution = solve_with_pyramids(problem, edges);
      ASSERT_EQ(solution.outcome, ContactOutcome::solved) << trial << " " << solution.violation;
      EXPECT_LT(solution.violation, 1e-9);
      // A sliding contact is off the direction of its slip by at most half the angle of a side.
      EXPECT_LT(contact_violation(problem, solution.velocity, solution.impulses),
                edges == 8 ? 0.5 : 0.1)
          << trial << " " << edges;
    }
  }
}

// A joint that is held at a rate, one that a drive moves with up to its effort, and a limit.
TEST(ContactPyramids, JointsKeepTheirIntervals) {
  ContactProblem problem{
      {{0, 2.0 * Eigen::MatrixXd::Identity(3, 3)}}, Eigen::Vector3d(1.0, 1.0, -1.0), {}};
  const auto on = [](int velocity) {
    return ContactCondition{.blocks = {{velocity, Eigen::RowVector4d::UnitX()}}, .rows = 1};
  };
  ContactCondition held = on(0);
  held.lower = -std::numeric_limits<double>::infinity();
  held.offset[0] = -0.25;
  ContactCondition brake = on(1);
  brake.lower = -0.5;
  brake.upper = 0.5;
  problem.contacts = {held, brake, on(2)};
  const ContactSolution solution = solve_with_pyramids(problem);
  ASSERT_EQ(solution.outcome, ContactOutcome::solved);
  EXPECT_LT((solution.velocity - Eigen::Vector3d(0.25, 0.75, 0.0)).norm(), 1e-14);
  EXPECT_NEAR(solution.impulses[0][0], -1.5, 1e-14);
  EXPECT_NEAR(solution.impulses[1][0], -0.5, 1e-14);
  EXPECT_NEAR(solution.impulses[2][0], 2.0, 1e-14);
  const ContactSolution on_cones = solve_contacts(problem);
  EXPECT_LT((solution.velocity - on_cones.velocity).norm(), 1e-9);
}

}  // namespace
}  // namespace prehend
