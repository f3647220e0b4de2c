// What epsilon and the volume must not depend on.
#include <algorithm>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "sim/quality/epsilon.h"
#include "sim/quality/wrench_hull.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

using Eigen::Vector3d;

struct Quality {
  double epsilon = 0.0;
  double volume = 0.0;
};

Quality quality(const Wrenches& wrenches) {
  return {epsilon_l1(wrenches).upper, wrench_hull(wrenches).volume};
}

void expect_equal(const Quality& a, const Quality& b) {
  EXPECT_NEAR(a.epsilon, b.epsilon, 2e-9 * a.epsilon + 1e-13);
  EXPECT_NEAR(a.volume, b.volume, 1e-8 * a.volume + 1e-13);
}

class Invariance : public testing::Test {
 protected:
  Random random{12};
  Contacts contacts = random_grasp(random, 5, 0.6);
  WrenchFrame frame{Vector3d(0.1, -0.2, 0.05), 0.8};
  Quality expected = quality(contact_wrenches(contacts, frame));
};

TEST_F(Invariance, HoldsTheObject) { EXPECT_GT(expected.epsilon, 0.01); }

TEST_F(Invariance, RotationOfTheWrenches) {
  const Eigen::Matrix3d rotation = random.rotation();
  Eigen::Matrix<double, 6, 6> both = Eigen::Matrix<double, 6, 6>::Zero();
  both.topLeftCorner<3, 3>() = rotation;
  both.bottomRightCorner<3, 3>() = rotation;
  expect_equal(quality(both * contact_wrenches(contacts, frame)), expected);
}

// The edges of a pyramid turn with the contact only around x, from which they are counted.
TEST_F(Invariance, RotationOfTheContactsAroundX) {
  for (const double angle : {0.3, 1.7, 3.0}) {
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, Vector3d::UnitX()).matrix();
    const WrenchFrame turned{rotation * frame.torque_origin, frame.torque_scale};
    expect_equal(quality(contact_wrenches(rotated(contacts, rotation), turned)), expected);
  }
}

TEST_F(Invariance, RotationOfFrictionlessContacts) {
  const Contacts slippery = loose_grasp(random, 16, 0.0);
  const Quality before = quality(contact_wrenches(slippery, {}));
  ASSERT_GT(before.epsilon, 0.0);
  expect_equal(quality(contact_wrenches(rotated(slippery, random.rotation()), {})), before);
}

TEST_F(Invariance, TranslationWithTheOrigin) {
  const Vector3d shift(3.0, -1.0, 2.0);
  for (Contact& contact : contacts) contact.position += shift;
  frame.torque_origin += shift;
  expect_equal(quality(contact_wrenches(contacts, frame)), expected);
}

TEST_F(Invariance, VolumeUnderTranslationOfTheOriginAlone) {
  frame.torque_origin += Vector3d(0.3, 0.1, -0.2);
  EXPECT_NEAR(quality(contact_wrenches(contacts, frame)).volume, expected.volume,
              1e-8 * expected.volume);
}

TEST_F(Invariance, UniformScaleWithTheTorqueScale) {
  for (const double scale : {1e-3, 0.5, 1000.0}) {
    Contacts larger = contacts;
    for (Contact& contact : larger) contact.position *= scale;
    const WrenchFrame wider{scale * frame.torque_origin, frame.torque_scale / scale};
    expect_equal(quality(contact_wrenches(larger, wider)), expected);
  }
}

TEST_F(Invariance, OrderOfContacts) {
  std::reverse(contacts.begin(), contacts.end());
  expect_equal(quality(contact_wrenches(contacts, frame)), expected);
  std::swap(contacts[0], contacts[3]);
  expect_equal(quality(contact_wrenches(contacts, frame)), expected);
}

TEST_F(Invariance, RepeatedContacts) {
  expect_equal(quality(contact_wrenches(doubled(random, contacts, 0.0), frame)), expected);
}

TEST_F(Invariance, InnerContactAddsNothing) {
  Wrenches wrenches = contact_wrenches(contacts, frame);
  const Wrench mean = wrenches.rowwise().mean();
  wrenches.conservativeResize(6, wrenches.cols() + 1);
  wrenches.rightCols<1>() = mean;
  expect_equal(quality(wrenches), expected);
}

TEST_F(Invariance, MoreContactsNeverHurt) {
  for (int i = 0; i < 5; ++i) {
    append(contacts, random_grasp(random, 1, 0.6));
    const Quality more = quality(contact_wrenches(contacts, frame));
    EXPECT_GE(more.epsilon, expected.epsilon * (1.0 - 1e-9));
    EXPECT_GE(more.volume, expected.volume * (1.0 - 1e-9));
    expected = more;
  }
}

}  // namespace
}  // namespace prehend::test
