// The comparison of three hands on a mug in Miller and Allen, "Graspit!" (2004): the section
// "Comparing the Grasps of an Object Using Three Different Hands", in which each grasps it from the
// side. docs/reference/three-hands.md shows it.
#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/scene/compiled_scene.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

Scene mug_with(const std::string& hand) {
  return load_scene(test::library_scene("mug"), {.hand = hand});
}

// The best grasp by a rule that comes from the side of a cylinder.
ScoredGrasp best_from_the_side(const Scene& scene) {
  PlanOptions options;
  options.rank.top = 300;
  options.volumes = false;
  options.free_closing = 0;  // in the paper the mug stands still
  for (const ScoredGrasp& grasp : plan(compile(scene), options).grasps) {
    if (grasp.rule.starts_with("cylinder side")) return grasp;
  }
  ADD_FAILURE() << "no grasp from the side with " << scene.hand.name;
  return {};
}

TEST(ThreeHands, AreInThePapersOrderOnTheMug) {
  Scene rubber_barrett = mug_with("barrett");
  for (Link& link : rubber_barrett.hand.links) {
    if (link.joint >= 0) link.material = "rubber";
  }
  const double plastic = best_from_the_side(mug_with("barrett")).trial.epsilon.lower;
  const double barrett = best_from_the_side(rubber_barrett).trial.epsilon.lower;
  const double dlr = best_from_the_side(mug_with("dlr")).trial.epsilon.lower;
  const Scene with_jaw = mug_with("parallel_jaw_wide");
  const ScoredGrasp jaw = best_from_the_side(with_jaw);
  EXPECT_GT(barrett, 1.5 * plastic);
  EXPECT_GT(barrett, 1.2 * jaw.trial.epsilon.lower);
  EXPECT_GT(dlr, 1.2 * jaw.trial.epsilon.lower);
  // A jaw resists a torque about the axis between its contacts least.
  const Vector3 torque = jaw.trial.epsilon.weakest.tail<3>();
  const Vector3 closing_O = jaw.trial.X_OH.linear() * with_jaw.hand.hand->closing;
  EXPECT_GT(std::abs(torque.normalized().dot(closing_O)), 0.95);
  EXPECT_GT(torque.norm(), 0.9 * jaw.trial.epsilon.weakest.norm());
}

}  // namespace
}  // namespace prehend
