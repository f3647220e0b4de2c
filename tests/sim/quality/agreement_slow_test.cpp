// epsilon_l1 against the full hull, on 2,024 seeded grasps of 23 families, and on thin and large
// ones.
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/sim/quality/agreement.h"

namespace prehend::test {
namespace {

// The smallest facet offset to compare with. Where qhull joggled near-duplicates, that of the
// grasp without them (the copies are its second half, `error` is how far they moved a wrench): the
// joggled hull is good to six or eight digits only.
struct Reference {
  WrenchHull hull;
  double error = 0.0;
};

Reference reference(const NamedGrasp& grasp, const Wrenches& wrenches) {
  Reference found{wrench_hull(wrenches)};
  if (!joggled(found.hull, wrenches)) return found;
  EXPECT_EQ(grasp.name.find("doubled at 1e-12"), 0u) << print(grasp);
  const Contacts once(grasp.contacts.begin(),
                      grasp.contacts.begin() + std::ssize(grasp.contacts) / 2);
  found.hull = wrench_hull(contact_wrenches(once, {}, grasp.edges));
  found.error = 2e-12;  // the shift times a force of at most sqrt(2)
  return found;
}

void expect_nine_digits(const NamedGrasp& grasp) {
  const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
  const auto [hull, error] = reference(grasp, wrenches);
  const EpsilonBracket bracket = epsilon_l1(wrenches);
  ASSERT_EQ(bracket.force_closure(), hull.force_closure()) << print(grasp);
  if (!hull.force_closure()) return;
  EXPECT_EQ(bracket.status, EpsilonStatus::converged) << print(grasp);
  EXPECT_NEAR(bracket.lower, hull.min_offset, 1e-9 * hull.min_offset + error) << print(grasp);
  EXPECT_NEAR(bracket.upper, hull.min_offset, 1e-9 * hull.min_offset + error) << print(grasp);
}

class Agreement : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Agreement, NineDigitsOnTwoThousandGrasps) {
  const std::vector<NamedGrasp> grasps = grasp_families(GetParam(), 8);
  ASSERT_EQ(grasps.size(), 8u * 23u);
  for (const NamedGrasp& grasp : grasps) expect_nine_digits(grasp);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Agreement, testing::Range<std::uint64_t>(200, 211));

TEST(Agreement, ThinGrasps) {
  for (const NamedGrasp& grasp : thin_grasps()) expect_agreement(grasp);
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
