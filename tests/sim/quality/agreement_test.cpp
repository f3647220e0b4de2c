// epsilon_l1 against the full hull, on a few grasps of each family. agreement_slow_test has
// thousands.
#include "tests/sim/quality/agreement.h"

#include <gtest/gtest.h>

namespace prehend::test {
namespace {

TEST(Agreement, EpsilonIsTheHullsSmallestOffset) {
  for (const NamedGrasp& grasp : grasp_families(100, 4)) expect_agreement(grasp);
}

TEST(Agreement, BothAnswersOccur) {
  int closed = 0;
  int open = 0;
  for (const NamedGrasp& grasp : grasp_families(100, 4)) {
    const Wrenches wrenches = contact_wrenches(grasp.contacts, {}, grasp.edges);
    ++(epsilon_l1(wrenches).force_closure() ? closed : open);
  }
  EXPECT_GT(closed, 50);
  EXPECT_GT(open, 15);
}

TEST(Agreement, ThinGrasps) {
  const std::vector<NamedGrasp> grasps = thin_grasps();
  for (std::size_t i = 3; i < grasps.size(); i += 10) expect_agreement(grasps[i]);
}

TEST(Agreement, SixteenContacts) {
  Random random(15);
  expect_agreement({"random", random_grasp(random, 16, 0.4), 4});
  expect_agreement({"patches", patches_grasp(random, 4, 0.4), 4});
}

}  // namespace
}  // namespace prehend::test
