#include "sim/quality/grasp_matrix.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

TEST(GraspMatrix, HasTheColumnsThatEachModelTransmits) {
  Contacts contacts(3);
  contacts[0].model = ContactModel::frictionless;
  contacts[2].model = ContactModel::soft_finger;
  const Eigen::MatrixXd matrix = grasp_matrix(contacts, {{0.0, 0.0, 1.0}, 2.0});
  ASSERT_EQ(matrix.cols(), 1 + 3 + 4);
  EXPECT_EQ(matrix.col(0), Wrench::Unit(2));
  EXPECT_EQ(matrix.col(7), 2.0 * Wrench::Unit(5));
}

// Six points at +-e_i of unit friction axes: G G' is 6 I for forces; torques of the unit sphere
// give 4 I.
TEST(GraspMatrix, OctahedronInClosedForm) {
  const Eigen::MatrixXd matrix = grasp_matrix(octahedron_grasp(0.5), {});
  EXPECT_NEAR(smallest_singular_value(matrix), 2.0, 1e-12);
  EXPECT_NEAR(isotropy(matrix), 2.0 / std::sqrt(6.0), 1e-12);
}

TEST(GraspMatrix, TwoPointsLoseADirection) {
  const Eigen::MatrixXd matrix = grasp_matrix(ring_grasp(2, 0.5), {});
  EXPECT_NEAR(smallest_singular_value(matrix), 0.0, 1e-12);
  EXPECT_NEAR(isotropy(matrix), 0.0, 1e-12);
  EXPECT_EQ(smallest_singular_value(grasp_matrix({}, {})), 0.0);
}

TEST(GraspMatrix, DoesNotChangeUnderRotation) {
  Random random(4);
  const Contacts contacts = random_grasp(random, 5, 0.4);
  const double value = smallest_singular_value(grasp_matrix(contacts, {}));
  const Contacts turned = rotated(contacts, random.rotation());
  EXPECT_NEAR(smallest_singular_value(grasp_matrix(turned, {})), value, 1e-12);
}

// Yoshikawa's planar arm of two links: l1 l2 |sin q2|.
TEST(GraspMatrix, ManipulabilityOfATwoLinkArm) {
  const double q1 = 0.3;
  const double q2 = 1.1;
  Eigen::Matrix2d jacobian;
  jacobian << -0.5 * std::sin(q1) - 0.3 * std::sin(q1 + q2), -0.3 * std::sin(q1 + q2),
      0.5 * std::cos(q1) + 0.3 * std::cos(q1 + q2), 0.3 * std::cos(q1 + q2);
  EXPECT_NEAR(manipulability(jacobian), 0.5 * 0.3 * std::sin(q2), 1e-14);
}

}  // namespace
}  // namespace prehend::test
