#include "sim/trial/sensitivity.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "sim/quality/epsilon.h"
#include "sim/quality/wrench.h"
#include "sim/trial/candidate.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// The Franka hand over a bar of 12 mm along its closing direction.
class Nearby : public testing::Test {
 protected:
  static const CompiledScene& scene() {
    static const CompiledScene kScene =
        test::compiled(find_robot("franka_hand"), make_box({0.012, 0.12, 0.02}), {});
    return kScene;
  }

  static const Trial& held() {
    static const Trial kHeld = [] {
      Candidate candidate;
      const double reach = scene().scene.hand.hand->origin.z() + 0.0373;
      candidate.X_OH = translation({0.0, 0.0, -reach});
      candidate.preshape = 0;
      return run_trial(scene(), candidate);
    }();
    return kHeld;
  }
};

// What is varied begins at the grasp as the trial found it.
TEST_F(Nearby, BeginsAtTheEpsilonOfTheContacts) {
  ASSERT_EQ(held().outcome, Outcome::stable);
  const TrialOptions options;
  const auto contacts = grasp_contacts(scene(), held().X_OH, held().joints, options);
  const Wrenches wrenches =
      contact_wrenches(contacts_of(contacts), scene().wrench_frame, options.cone_edges);
  EXPECT_EQ(epsilon_l1(wrenches).lower, held().epsilon.lower);
}

// Flat fingers close to the same small gap on both sides, far from the threshold.
TEST_F(Nearby, IsNarrowWhereNoContactIsNearTheThreshold) {
  const Interval range = epsilon_nearby(scene(), held(), {});
  EXPECT_LE(range.lower, held().epsilon.lower);
  EXPECT_GE(range.upper, held().epsilon.lower);
  EXPECT_GT(range.lower, 0.9 * held().epsilon.lower);
}

// With the threshold at the largest gap of all, a tenth less loses that contact, and with hard
// contacts of one finger alone nothing is held. A tenth less of a larger threshold loses none.
TEST_F(Nearby, ReachesZeroWhereTheThresholdIsTheGap) {
  TrialOptions options;
  options.contacts = ContactKind::hard;
  double largest = 0.0;
  for (const GraspContact& contact : grasp_contacts(scene(), held().X_OH, held().joints, options)) {
    largest = std::max(largest, contact.gap);
  }
  options.contact.threshold = 1.01 * largest;
  EXPECT_EQ(epsilon_nearby(scene(), held(), options).lower, 0.0);
  options.contact.threshold = 1.2 * largest;
  EXPECT_GT(epsilon_nearby(scene(), held(), options).lower, 0.0);
}

}  // namespace
}  // namespace prehend
