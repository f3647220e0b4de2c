// Grasps whose contacts are pads of finite elements.
#include "sim/trial/pad_contacts.h"

#include <set>

#include <gtest/gtest.h>

#include "sim/base/input_error.h"
#include "sim/trial/grasp_contacts.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

TrialOptions fem(PadPatchModel patch = PadPatchModel::nodes) {
  TrialOptions options;
  options.contacts = ContactKind::fem;
  options.pads.patch = patch;
  options.pads.elements.most_nodes = 100;
  return options;
}

Candidate over_bar() {
  const Robot hand = find_robot("franka_hand");
  Candidate candidate;
  candidate.X_OH = translation({0.0, 0.0, -hand.hand->origin.z() - 0.0373});
  candidate.preshape = 0;
  return candidate;
}

CompiledScene bar_scene() {
  return test::compiled(find_robot("franka_hand"), make_box({0.012, 0.12, 0.02}));
}

TEST(PadContacts, ABarIsHeldByTwoPads) {
  const CompiledScene scene = bar_scene();
  const Trial trial = run_trial(scene, over_bar(), fem());
  ASSERT_EQ(trial.outcome, Outcome::stable);
  std::set<std::string> links;
  for (const GraspContact& contact : trial.contacts) {
    links.insert(scene.links[static_cast<std::size_t>(contact.link)].name);
    EXPECT_NEAR(std::abs(contact.point.position.x()), 0.006, 1e-9);
    EXPECT_LT(contact.point.torsion, 2e-3);
  }
  EXPECT_EQ(links, (std::set<std::string>{"left_pad", "right_pad"}));
}

TEST(PadContacts, ALimitSurfaceIsOneSoftFingerAPad) {
  const Trial trial = run_trial(bar_scene(), over_bar(), fem(PadPatchModel::limit_surface));
  ASSERT_EQ(trial.outcome, Outcome::stable);
  int patches = 0;
  for (const GraspContact& contact : trial.contacts) {
    if (contact.point.model != ContactModel::soft_finger) continue;
    ++patches;
    // A patch of some 17 by 17 mm, or 20 by 17 where the bar covers less.
    EXPECT_GT(contact.point.torsion, 4e-3);
    EXPECT_LT(contact.point.torsion, 9e-3);
  }
  EXPECT_EQ(patches, 2);
}

TEST(PadContacts, APadPressesWithTheEffortOfItsSlide) {
  const CompiledScene scene = bar_scene();
  const Trial trial = run_trial(scene, over_bar(), fem());
  RobotPoses poses;
  robot_poses(scene.scene.hand, trial.joints, poses);
  for (const CompiledLink& link : scene.links) {
    if (!link.pad) continue;
    const std::vector<SurfaceContact> touching{
        {.position = {0.006, 0, 0}, .normal = {-1, 0, 0}, .gap = 5e-5}};
    const auto pressing = pad_pressing(scene.scene.hand, link, trial.X_OH, poses, touching, 10.0);
    ASSERT_TRUE(pressing);
    EXPECT_NEAR(pressing->load, 70.0, 1e-9);  // stated in the robot file
    EXPECT_NEAR(pressing->direction_O.x(), -1.0, 1e-12);
  }
}

TEST(PadContacts, HandsWithoutPadsAreRefusedByName) {
  const CompiledScene scene = test::compiled(find_robot("barrett"), make_box({0.05, 0.05, 0.05}));
  TrialOptions options;
  EXPECT_NO_THROW(require_pads(scene, options));
  options.contacts = ContactKind::fem;
  try {
    require_pads(scene, options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.file(), "barrett");
    EXPECT_EQ(error.field(), "contacts");
  }
}

TEST(PadContacts, OtherContactsDoNotKnowOfPads) {
  Robot bare = find_robot("franka_hand");
  for (Link& link : bare.links) link.pad.reset();
  const CompiledScene without = test::compiled(bare, make_box({0.012, 0.12, 0.02}));
  const Trial a = run_trial(without, over_bar(), {});
  const Trial b = run_trial(bar_scene(), over_bar(), {});
  EXPECT_EQ(a.epsilon.lower, b.epsilon.lower);
  ASSERT_EQ(a.contacts.size(), b.contacts.size());
}

}  // namespace
}  // namespace prehend
