#include "sim/quality/wrench.h"

#include <limits>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

using Eigen::Vector3d;

TEST(ContactTangents, FirstIsAlongNormalCrossX) {
  const Tangents tangents = contact_tangents(Vector3d::UnitZ());
  EXPECT_EQ(tangents.first, Vector3d::UnitY());
  EXPECT_EQ(tangents.second, -Vector3d::UnitX());
}

TEST(ContactTangents, NormalAlongXUsesZ) {
  EXPECT_EQ(contact_tangents(Vector3d::UnitX()).first, -Vector3d::UnitY());
  EXPECT_EQ(contact_tangents(-Vector3d::UnitX()).first, Vector3d::UnitY());
  // Within 1e-6 of x, x is not used.
  EXPECT_NEAR(contact_tangents(Vector3d(1.0, 0.0, 1e-7).normalized()).first.y(), -1.0, 1e-12);
  EXPECT_NEAR(contact_tangents(Vector3d(1.0, 0.0, 1e-5).normalized()).first.y(), 1.0, 1e-12);
}

TEST(ContactTangents, AreRightHandedAndOrthonormal) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector3d normal = random.direction();
    const Tangents tangents = contact_tangents(normal);
    EXPECT_NEAR(tangents.first.norm(), 1.0, 1e-14);
    EXPECT_NEAR((tangents.first.cross(tangents.second) - normal).norm(), 0.0, 1e-14);
  }
}

TEST(ContactWrenches, FourEdgesByHand) {
  const Contacts contacts = {{Vector3d(1.0, 2.0, 3.0), Vector3d::UnitZ(), 0.5}};
  const WrenchFrame frame{Vector3d(0.0, 2.0, 3.0), 0.25};
  const Wrenches wrenches = contact_wrenches(contacts, frame, 4);
  Wrenches expected(6, 4);
  // The arm is x / 4, and x cross (fx, fy, fz) is (0, -fz, fy).
  expected.col(0) << 0.0, 0.5, 1.0, 0.0, -0.25, 0.125;
  expected.col(1) << -0.5, 0.0, 1.0, 0.0, -0.25, 0.0;
  expected.col(2) << 0.0, -0.5, 1.0, 0.0, -0.25, -0.125;
  expected.col(3) << 0.5, 0.0, 1.0, 0.0, -0.25, 0.0;
  EXPECT_TRUE(wrenches.isApprox(expected, 1e-15)) << wrenches;
}

TEST(ContactWrenches, NormalForceIsUnitAndTangentialIsFriction) {
  Random random(2);
  const Contacts contacts = random_grasp(random, 7, 0.7);
  for (const int edges : {3, 4, 8, 13}) {
    const Wrenches wrenches = contact_wrenches(contacts, {}, edges);
    ASSERT_EQ(wrenches.cols(), 7 * edges);
    for (Eigen::Index j = 0; j < wrenches.cols(); ++j) {
      const Contact& contact = contacts[static_cast<std::size_t>(j / edges)];
      const Vector3d force = wrenches.col(j).head<3>();
      EXPECT_NEAR(force.dot(contact.normal), 1.0, 1e-14);
      EXPECT_NEAR(force.cross(contact.normal).norm(), 0.7, 1e-14);
      EXPECT_TRUE(wrenches.col(j).tail<3>().isApprox(contact.position.cross(force), 1e-14));
    }
  }
}

TEST(ContactWrenches, FrictionlessContactKeepsItsColumns) {
  const Contacts contacts = {{Vector3d::Zero(), Vector3d::UnitY(), 0.0}};
  const Wrenches wrenches = contact_wrenches(contacts, {}, 8);
  ASSERT_EQ(wrenches.cols(), 8);
  for (int j = 0; j < 8; ++j) EXPECT_EQ(wrenches.col(j), Wrench::Unit(1));
}

TEST(ContactWrenches, NoContactsNoColumns) { EXPECT_EQ(contact_wrenches({}, {}).cols(), 0); }

TEST(ContactWrenches, NearlyUnitNormalIsNormalised) {
  const Contacts contacts = {{Vector3d::Zero(), Vector3d(0.0, 0.0, 1.0005), 0.0}};
  EXPECT_EQ(contact_wrenches(contacts, {})(2, 0), 1.0);
}

std::string message(const Contacts& contacts, const WrenchFrame& frame = {}, int edges = 8) {
  try {
    contact_wrenches(contacts, frame, edges);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ContactWrenches, ErrorsNameTheContactAndTheValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const Contact good;
  Contact bad = good;
  bad.position.y() = nan;
  EXPECT_EQ(message({good, bad}), "contacts[1].position: not finite (0, nan, 0)");
  bad = good;
  bad.normal.x() = infinity;
  EXPECT_EQ(message({bad}), "contacts[0].normal: not finite (inf, 0, 1)");
  bad = good;
  bad.normal.z() = 1.002;
  EXPECT_EQ(message({good, good, bad}), "contacts[2].normal: not unit (0, 0, 1.002)");
  bad = good;
  bad.friction = -0.5;
  EXPECT_EQ(message({bad}), "contacts[0].friction: must be from 0 to 1e+06 (-0.5)");
}

TEST(ContactWrenches, ErrorsNameTheFrame) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message({}, {Vector3d(0.0, 0.0, nan), 1.0}), "torque_origin: not finite (0, 0, nan)");
  EXPECT_EQ(message({}, {Vector3d::Zero(), 0.0}), "torque_scale: must be from 1e-09 to 1e+09 (0)");
  EXPECT_EQ(message({}, {}, 2), "edges: of a friction pyramid: must be from 3 to 1024 (2)");
}

}  // namespace
}  // namespace prehend::test
