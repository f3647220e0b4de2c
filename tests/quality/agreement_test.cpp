// epsilon_l1 against the full hull, on several hundred grasps of some twenty families.
#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "sim/quality/epsilon.h"
#include "sim/quality/start_simplex.h"
#include "sim/quality/wrench_hull.h"
#include "tests/quality/grasp_families.h"

namespace prehend::test {
namespace {

// The grasp, to paste into a test.
std::string print(const NamedGrasp& grasp) {
  std::ostringstream text;
  text.precision(17);
  text << grasp.name << ", " << grasp.edges << " edges: {";
  for (const Contact& contact : grasp.contacts) {
    const Eigen::Vector3d& p = contact.position;
    const Eigen::Vector3d& n = contact.normal;
    text << "{{" << p.x() << ", " << p.y() << ", " << p.z() << "}, {" << n.x() << ", " << n.y()
         << ", " << n.z() << "}, " << contact.friction << "}, ";
  }
  return text.str() + "}";
}

void expect_agreement(const NamedGrasp& grasp) {
  const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
  const WrenchHull hull = wrench_hull(wrenches);
  const EpsilonBracket bracket = epsilon_l1(wrenches);
  ASSERT_EQ(bracket.force_closure(), hull.force_closure()) << print(grasp);
  if (!hull.force_closure()) {
    EXPECT_EQ(bracket.status, EpsilonStatus::no_force_closure) << print(grasp);
    EXPECT_EQ(bracket.upper, 0.0) << print(grasp);
    return;
  }
  EXPECT_EQ(bracket.status, EpsilonStatus::converged) << print(grasp);
  // Rounding of qhull's own planes, and the joggle where it needed one.
  const double scale = wrenches.cwiseAbs().maxCoeff();
  const bool joggled = hull.doubt > 1.01 * kFlatness * scale;
  const double tolerance = 1e-9 * hull.min_offset + (joggled ? hull.doubt : 0.0) + 1e-14 * scale;
  EXPECT_NEAR(bracket.lower, hull.min_offset, tolerance) << print(grasp);
  EXPECT_NEAR(bracket.upper, hull.min_offset, tolerance) << print(grasp);
}

class Agreement : public testing::TestWithParam<int> {};

TEST_P(Agreement, EpsilonIsTheHullsSmallestOffset) {
  for (const NamedGrasp& grasp : grasp_families(static_cast<std::uint64_t>(GetParam()), 5)) {
    expect_agreement(grasp);
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Agreement, testing::Range(100, 106));

TEST(Agreement, BothAnswersOccur) {
  int closed = 0;
  int open = 0;
  for (const NamedGrasp& grasp : grasp_families(100, 5)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    ++(epsilon_l1(wrenches).force_closure() ? closed : open);
  }
  EXPECT_GT(closed, 50);
  EXPECT_GT(open, 15);
}

// Flat grasps thickened to 1e-8: their epsilon is near the limit of flatness, and growth stalls on
// some of them (number 123), so that the hull decides.
TEST(Agreement, ThinGrasps) {
  Random random(16);
  for (int i = 0; i < 130; ++i) {
    Contacts contacts = i % 2 == 1 ? ring_grasp(2, 0.4) : cube_grasp(0.0);
    Contacts copies = contacts;
    const double shift = std::pow(10.0, random.between(-8.0, -7.0));
    for (Contact& contact : copies) {
      contact.position += shift * random.direction();
      contact.normal = (contact.normal + shift * random.direction()).normalized();
    }
    append(contacts, copies);
    expect_agreement({"thin " + std::to_string(i), contacts, 8});
  }
}

TEST(Agreement, ManyContacts) {
  Random random(15);
  for (const int n : {16, 30}) {
    expect_agreement({"random", random_grasp(random, n, 0.4), 4});
    expect_agreement({"patches", patches_grasp(random, n / 4, 0.4), 4});
  }
  expect_agreement({"sixty without friction", random_grasp(random, 60, 0.0), 3});
  expect_agreement({"sixty loose", loose_grasp(random, 60, 0.0), 3});
}

}  // namespace
}  // namespace prehend::test
