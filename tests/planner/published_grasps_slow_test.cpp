// The 1,000 published grasps of ten scanned objects, evaluated.
#include <gtest/gtest.h>

#include "planner/plan.h"
#include "sim/geometry/mesh_file.h"
#include "sim/robot/robot_file.h"
#include "tests/planner/published_grasps.h"
#include "tests/shared_data.h"

namespace prehend::test {
namespace {

CompiledScene franka_at(const std::string& object) {
  Scene scene;
  scene.object = make_graspable(object, load_mesh(shared("data/ycb/" + object + ".obj")).mesh,
                                Material::plastic);
  scene.hand = find_robot("franka_hand");
  return compile(std::move(scene));
}

// What each outcome promises of the trial's numbers.
void expect_consistent(const Trial& trial) {
  const bool touched =
      trial.outcome == Outcome::stable || trial.outcome == Outcome::not_force_closure;
  EXPECT_EQ(touched, !trial.contacts.empty());
  EXPECT_EQ(trial.outcome == Outcome::stable, trial.epsilon.lower > 0.0);
  EXPECT_TRUE(trial.X_OH.matrix().allFinite());
  for (const GraspContact& contact : trial.contacts) {
    EXPECT_GE(contact.gap, 0.0);
    EXPECT_LE(contact.gap, 1e-4);
    EXPECT_NEAR(contact.point.normal.norm(), 1.0, 1e-9);
  }
}

struct Published {
  const char* object;
  int at_least_stable;  // a floor under what was measured, for hard-finger contacts
};

class PublishedGrasps : public testing::TestWithParam<Published> {};

TEST_P(PublishedGrasps, EachGetsAnOutcome) {
  const std::string object = GetParam().object;
  const std::string file = "data/grasps/dexycb_franka_" + object + ".json";
  PREHEND_NEEDS_SHARED(file);
  const CompiledScene scene = franka_at(object);
  const std::vector<Candidate> published = published_grasps(shared(file), scene);
  ASSERT_EQ(published.size(), 100U);
  const PlanResult result = evaluate(scene, published);
  ASSERT_EQ(result.grasps.size(), 100U);
  for (const ScoredGrasp& grasp : result.grasps) expect_consistent(grasp.trial);
  int total = 0;
  for (const Outcome outcome : kOutcomes) {
    const int count = result.outcomes[static_cast<std::size_t>(outcome)];
    RecordProperty(std::string(outcome_name(outcome)), count);
    total += count;
  }
  EXPECT_EQ(total, 100);
  EXPECT_GE(result.outcomes[static_cast<std::size_t>(Outcome::stable)], GetParam().at_least_stable);
}

INSTANTIATE_TEST_SUITE_P(DexYcb, PublishedGrasps,
                         testing::Values(Published{"banana", 30}, Published{"bowl", 0},
                                         Published{"cracker_box", 40}, Published{"large_clamp", 8},
                                         Published{"large_marker", 6}, Published{"mug", 0},
                                         Published{"mustard_bottle", 42},
                                         Published{"pitcher_base", 1}, Published{"power_drill", 42},
                                         Published{"tomato_soup_can", 38}),
                         [](const auto& published) { return std::string(published.param.object); });

}  // namespace
}  // namespace prehend::test
