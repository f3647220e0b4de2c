#include "sim/quality/robust_epsilon.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/quality/wrench_space.h"
#include "tests/support/grasp_families.h"

namespace prehend::test {
namespace {

NoiseOptions no_noise() {
  NoiseOptions noise;
  noise.pose_position = noise.pose_angle = 0.0;
  noise.contact_position = noise.normal_angle = noise.friction = 0.0;
  return noise;
}

TEST(RobustEpsilon, WithoutNoiseIsEpsilon) {
  const Contacts contacts = octahedron_grasp(0.5);
  const double value = grasp_epsilon(contacts, {}).lower;
  const RobustEpsilon robust = robust_epsilon(contacts, {}, {}, no_noise());
  EXPECT_NEAR(robust.mean, value, 1e-9);
  EXPECT_NEAR(robust.percentile_5, value, 1e-9);
  EXPECT_NEAR(robust.force_closure, 1.0, 1e-9);
}

TEST(RobustEpsilon, OfAMarginalGraspIsASmallProbability) {
  const Contacts contacts = ring_grasp(3, 0.05);
  NoiseOptions noise;
  noise.normal_angle = 0.2;
  const RobustEpsilon robust = robust_epsilon(contacts, {}, {}, noise);
  EXPECT_LT(robust.force_closure, 0.9);
  EXPECT_EQ(robust.percentile_5, 0.0);
  EXPECT_EQ(robust_epsilon(ring_grasp(2, 0.5), {}, {}).force_closure, 0.0);  // flat, however moved
}

// Epsilon of an octahedron is about proportional to its friction: so is its spread.
TEST(RobustEpsilon, NoiseSpreadsAndFrictionScales) {
  const Contacts contacts = octahedron_grasp(0.4);
  NoiseOptions noise = no_noise();
  noise.friction = 0.1;
  const RobustEpsilon some = robust_epsilon(contacts, {}, {}, noise);
  noise.friction = 0.3;
  const RobustEpsilon more = robust_epsilon(contacts, {}, {}, noise);
  EXPECT_LT(some.percentile_5, some.mean);
  EXPECT_LT(more.percentile_5, some.percentile_5);
}

TEST(RobustEpsilon, AContactsOwnDeviationReplacesThatOfAll) {
  Contacts contacts = octahedron_grasp(0.4);
  NoiseOptions noise = no_noise();
  noise.friction = 0.3;
  const RobustEpsilon of_all = robust_epsilon(contacts, {}, {}, noise);
  for (Contact& contact : contacts) contact.friction_deviation = 0.3;
  noise.friction = 0.0;
  EXPECT_EQ(robust_epsilon(contacts, {}, {}, noise).mean, of_all.mean);
  noise.friction = 0.3;
  for (Contact& contact : contacts) contact.friction_deviation = 0.0;
  const RobustEpsilon known = robust_epsilon(contacts, {}, {}, noise);
  EXPECT_NEAR(known.mean, grasp_epsilon(contacts, {}).lower, 1e-9);
}

TEST(RobustEpsilon, SameSeedSameBytesAndSizeDoesNotMatter) {
  const Contacts contacts = cube_grasp(0.4);
  NoiseOptions noise;
  noise.samples = 50;
  const RobustEpsilon one = robust_epsilon(contacts, {}, {}, noise);
  EXPECT_EQ(one.mean, robust_epsilon(contacts, {}, {}, noise).mean);
  Contacts small = contacts;
  for (Contact& contact : small) contact.position *= 1e-3;
  EXPECT_NEAR(robust_epsilon(small, {Eigen::Vector3d::Zero(), 1e3}, {}, noise).mean, one.mean,
              1e-9);
  noise.seed = 2;
  EXPECT_NE(one.mean, robust_epsilon(contacts, {}, {}, noise).mean);
}

TEST(RobustEpsilon, RefusesNonsense) {
  NoiseOptions noise;
  noise.samples = 0;
  EXPECT_THROW(robust_epsilon({}, {}, {}, noise), InputError);
  noise = {};
  noise.friction = -0.1;
  EXPECT_THROW(robust_epsilon({}, {}, {}, noise), InputError);
  noise.friction = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(robust_epsilon({}, {}, {}, noise), InputError);
}

}  // namespace
}  // namespace prehend::test
