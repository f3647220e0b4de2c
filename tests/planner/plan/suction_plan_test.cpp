// Plans of hands with suction cups.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "planner/plan/propose/suction_rules.h"
#include "planner/results/grasps_file.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

PlanOptions suction_trials() {
  PlanOptions options;
  options.search.trials = 100;
  return options;
}

CompiledScene box_and_cups(const char* hand) {
  return test::compiled(find_robot(hand), make_box({0.12, 0.1, 0.09}));
}

// Of the object's centre of mass from the line through the middle of the cups along their axis.
double off_center_of(const CompiledScene& scene, const ScoredGrasp& grasp) {
  Vector3 middle = Vector3::Zero();
  for (const GraspContact& contact : grasp.trial.contacts) {
    middle += contact.point.position / static_cast<double>(grasp.trial.contacts.size());
  }
  const Vector3 axis = grasp.trial.contacts.front().point.normal;
  return (scene.wrench_frame.torque_origin - middle).cross(axis).norm();
}

TEST(SuctionPlan, HoldsABoxNearItsCentreOfMass) {
  for (const char* hand : {"suction_cup_30", "suction_array_4"}) {
    const CompiledScene scene = box_and_cups(hand);
    const PlanResult result = plan(scene, suction_trials());
    ASSERT_FALSE(result.grasps.empty()) << hand;
    const ScoredGrasp& best = result.grasps.front();
    EXPECT_EQ(best.trial.contacts.size(), scene.scene.hand.hand->cups.size());
    EXPECT_LT(off_center_of(scene, best), 0.01) << hand;
    EXPECT_FALSE(best.free);
    EXPECT_TRUE(std::all_of(
        best.trial.contacts.begin(), best.trial.contacts.end(),
        [](const GraspContact& contact) { return contact.point.model == ContactModel::suction; }));
  }
}

TEST(SuctionPlan, SameBytesOnOneAndTwoThreadsAndWhenRead) {
  const CompiledScene scene = box_and_cups("suction_cup_30");
  const PlanResult one = plan(scene, suction_trials(), RunContext{.threads = 1});
  const PlanResult two = plan(scene, suction_trials(), RunContext{.threads = 2});
  ASSERT_FALSE(one.grasps.empty());
  EXPECT_EQ(grasps_json(scene, one, {}), grasps_json(scene, two, {}));
}

TEST(SuctionPlan, PlacesAreFlatApartAndNearestTheCentreFirst) {
  const CompiledScene scene = box_and_cups("suction_cup_30");
  const std::vector<SuctionPlace> places = suction_places(scene);
  ASSERT_GT(places.size(), 20U);
  const double radius = scene.scene.hand.hand->cups[0].radius;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i > 0) EXPECT_LE(places[i - 1].off_center, places[i].off_center);
    EXPECT_EQ(places[i].sealed, 1);
    // Within the face.
    const Vector3 p = places[i].point_O.cwiseAbs();
    const Vector3 room = Vector3(0.06, 0.05, 0.045) - p;
    int near = 0;
    for (const double r : room) near += r < 0.9 * radius;
    EXPECT_LE(near, 1) << p.transpose();
  }
}

TEST(SuctionPlan, ScenesThatDoNotGoWithCupsAreRefused) {
  const CompiledScene scene = box_and_cups("suction_cup_30");
  PlanOptions options = suction_trials();
  options.trial.formation.dynamic = true;
  const InputError error = test::refusal_of([&] { (void)plan(scene, options); });
  EXPECT_NE(std::string(error.what()).find("plan without --dynamic"), std::string::npos);
}

// The lip is a circle on a ball; a stick is narrower than it.
TEST(SuctionPlan, HoldsABallButNotAThinStick) {
  const CompiledScene ball = test::compiled(find_robot("suction_cup_30"), make_sphere(0.035, 4));
  EXPECT_FALSE(plan(ball, suction_trials()).grasps.empty());
  const CompiledScene stick =
      test::compiled(find_robot("suction_cup_30"), make_box({0.2, 0.025, 0.025}));
  const PlanResult none = plan(stick, suction_trials());
  EXPECT_TRUE(none.grasps.empty());
  EXPECT_GT(none.outcomes[Outcome::no_seal], 0);
}

}  // namespace
}  // namespace prehend
