// The 1,000 published grasps of ten scanned objects, evaluated.
#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/robot/files/robot_file.h"
#include "sim/shape/files/mesh_file.h"
#include "tests/support/published_grasps.h"
#include "tests/support/shared_data.h"

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
    EXPECT_LE(contact.gap, 1e-3);
    EXPECT_NEAR(contact.point.normal.norm(), 1.0, 1e-9);
  }
}

struct Published {
  const char* object;
  // Floors under what was measured, with rubber pads as hard points and as soft fingers.
  int hard;
  int soft;
};

// Every grasp must get an outcome; how many are stable.
int count_stable(const CompiledScene& scene, const std::vector<Candidate>& grasps, bool soft) {
  EvaluateOptions options;
  options.trial.contacts = soft ? ContactKind::soft : ContactKind::hard;
  options.volumes = 0;  // which take ten times as long as the outcomes
  const PlanResult result = evaluate(scene, grasps, options);
  EXPECT_EQ(result.grasps.size(), grasps.size());
  for (const ScoredGrasp& grasp : result.grasps) expect_consistent(grasp.trial);
  int total = 0;
  for (const Outcome outcome : kAll<Outcome>) {
    const int count = result.outcomes[outcome];
    const std::string name = std::string(name_of(outcome)) + (soft ? "_soft" : "_hard");
    testing::Test::RecordProperty(name, count);
    total += count;
  }
  EXPECT_EQ(total, static_cast<int>(grasps.size()));
  return result.outcomes[Outcome::stable];
}

class PublishedGrasps : public testing::TestWithParam<Published> {};

TEST_P(PublishedGrasps, EachGetsAnOutcome) {
  const std::string object = GetParam().object;
  const std::string file = "data/grasps/dexycb_franka_" + object + ".json";
  PREHEND_NEEDS_SHARED(file);
  const CompiledScene scene = franka_at(object);
  const std::vector<Candidate> published = published_grasps(shared(file), scene);
  ASSERT_EQ(published.size(), 100U);
  EXPECT_GE(count_stable(scene, published, false), GetParam().hard);
  EXPECT_GE(count_stable(scene, published, true), GetParam().soft);
}

INSTANTIATE_TEST_SUITE_P(
    DexYcb, PublishedGrasps,
    testing::Values(Published{"banana", 94, 94}, Published{"bowl", 86, 87},
                    Published{"cracker_box", 100, 100}, Published{"large_clamp", 86, 90},
                    Published{"large_marker", 95, 96}, Published{"mug", 87, 92},
                    Published{"mustard_bottle", 91, 97}, Published{"pitcher_base", 74, 83},
                    Published{"power_drill", 93, 95}, Published{"tomato_soup_can", 84, 95}),
    [](const auto& published) { return std::string(published.param.object); });

}  // namespace
}  // namespace prehend::test
