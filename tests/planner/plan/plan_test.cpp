#include "planner/plan/plan.h"

#include <fstream>

#include <gtest/gtest.h>

#include "planner/results/grasps_file.h"
#include "sim/base/json/json_field.h"
#include "sim/quality/wrench_hull.h"
#include "sim/robot/files/robot_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/shape/object_generator.h"
#include "sim/trial/grasp_contacts.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

CompiledScene default_scene() { return compile(load_scene(find_scene("mug"))); }

PlanOptions few_candidates() {
  PlanOptions options;
  options.search.trials = 40;
  return options;
}

TEST(Plan, SameBytesOnOneAndTwoThreads) {
  const CompiledScene scene = default_scene();
  const PlanResult one = plan(scene, few_candidates(), RunContext{.threads = 1});
  const PlanResult two = plan(scene, few_candidates(), RunContext{.threads = 2});
  ASSERT_FALSE(one.grasps.empty());
  EXPECT_EQ(grasps_json(scene, one, {}), grasps_json(scene, two, {}));
}

// The seed of the plan decides, whatever the seeds of its stages were.
TEST(Plan, OneSeedGoesToAllThatIsRandom) {
  const CompiledScene scene = default_scene();
  PlanOptions options = few_candidates();
  options.seed = 7;
  const std::string seven = grasps_json(scene, plan(scene, options), {});
  options.primitives.seed = 3;
  options.trial.reach.kinematics.seed = 3;
  EXPECT_EQ(grasps_json(scene, plan(scene, options), {}), seven);
  options.seed = 1;
  options.primitives.seed = 7;
  EXPECT_NE(grasps_json(scene, plan(scene, options), {}), seven);
}

TEST(Plan, OutcomesCountEveryTrialAndGraspsAreRanked) {
  const CompiledScene scene = default_scene();
  const PlanResult result = plan(scene, few_candidates(), RunContext{.threads = 2});
  int total = 0;
  for (int count : result.outcomes.entries) total += count;
  EXPECT_EQ(total, 40);
  for (std::size_t i = 1; i < result.grasps.size(); ++i) {
    const ScoredGrasp& better = result.grasps[i - 1];
    const ScoredGrasp& grasp = result.grasps[i];
    // At least as many as are wanted are closed on a free object, unless there are fewer.
    ASSERT_TRUE(grasp.free || static_cast<int>(i) >= few_candidates().free_closing);
    ASSERT_TRUE(better.free || !grasp.free);
    if (grasp.free) {
      EXPECT_GE(better.free->epsilon.lower, grasp.free->epsilon.lower);
    } else if (!better.free) {
      EXPECT_GE(better.trial.epsilon.lower, grasp.trial.epsilon.lower);
    }
  }
  for (const ScoredGrasp& grasp : result.grasps) {
    EXPECT_EQ(grasp.trial.outcome, Outcome::stable);
    EXPECT_GT(grasp.volume, 0.0);
  }
}

// A planned grasp, read back from its file, is the same grasp: the pose comes back through a
// quaternion, so to rounding.
TEST(Plan, EvaluateRepeatsWhatPlanFound) {
  const CompiledScene scene = default_scene();
  const PlanResult planned = plan(scene, few_candidates(), RunContext{.threads = 2});
  const std::filesystem::path file = testing::TempDir() + "/planned.json";
  std::ofstream(file) << grasps_json(scene, planned, {});
  const std::vector<Candidate> candidates =
      given_candidates(read_grasps(JsonFile(file), scene), scene);
  const PlanResult again = evaluate(scene, candidates);
  ASSERT_EQ(again.grasps.size(), planned.grasps.size());
  int same = 0;
  for (std::size_t i = 0; i < again.grasps.size(); ++i) {
    const Trial& a = planned.grasps[i].trial;
    const Trial& b = again.grasps[i].trial;
    if (b.outcome == Outcome::stable && std::abs(a.epsilon.lower - b.epsilon.lower) < 0.02) ++same;
  }
  EXPECT_EQ(same, static_cast<int>(planned.grasps.size()));
}

// Volumes that were not asked for are left out, which is not a cancelled run.
TEST(Plan, EvaluateComputesAsManyVolumesAsAsked) {
  const CompiledScene scene = default_scene();
  const PlanResult planned = plan(scene, few_candidates(), RunContext{.threads = 2});
  ASSERT_GE(planned.grasps.size(), 3U);
  std::vector<Candidate> candidates;
  for (const ScoredGrasp& grasp : planned.grasps) candidates.push_back(grasp.candidate);
  EvaluateOptions options;
  for (const std::size_t volumes :
       {std::size_t{0}, std::size_t{2}, candidates.size(), std::size_t{1000}}) {
    options.volumes = volumes;
    const PlanResult result = evaluate(scene, candidates, options);
    EXPECT_EQ(result.status, PlanStatus::complete);
    ASSERT_EQ(result.grasps.size(), candidates.size());
    for (std::size_t i = 0; i < result.grasps.size(); ++i) {
      EXPECT_EQ(result.grasps[i].volume.has_value(), i < volumes) << i << " of " << volumes;
    }
  }
}

// The epsilon that ranks is that of the full hull.
TEST(Plan, RanksAsTheFullHullWould) {
  const CompiledScene scene = default_scene();
  const PlanResult result = plan(scene, few_candidates(), RunContext{.threads = 2});
  ASSERT_FALSE(result.grasps.empty());
  for (const ScoredGrasp& grasp : result.grasps) {
    const Wrenches wrenches =
        contact_wrenches(contacts_of(grasp.trial.contacts), scene.wrench_frame);
    const double epsilon = wrench_hull(wrenches).min_offset;
    EXPECT_NEAR(grasp.trial.epsilon.lower, epsilon, 1e-9 * epsilon);
  }
}

// A batch of none would end as "no grasp to propose", a gap beyond the threshold as no contact in
// any trial.
TEST(Plan, RefusesSettingsOutOfTheirRange) {
  const CompiledScene scene = default_scene();
  const auto refusal = [&](const auto& change) {
    PlanOptions options = few_candidates();
    change(options);
    return std::string(test::refusal_of([&] { (void)plan(scene, options); }).what());
  };
  EXPECT_EQ(refusal([](PlanOptions& o) { o.search.batch = 0; }),
            "search.batch: must be at least 1 (0)");
  EXPECT_EQ(refusal([](PlanOptions& o) { o.trial.contact_gap = 1e-4; }),
            "trial.contact_gap: must be at most 0.9 of the contact threshold");
  EXPECT_EQ(refusal([](PlanOptions& o) { o.primitives.points = 99; }),
            "primitives.points: must be at least 100 (99)");
  EvaluateOptions options;
  options.uncertainty.samples = 0;
  EXPECT_STREQ(test::refusal_of([&] { (void)evaluate(scene, {}, options); }).what(),
               "uncertainty.samples: must be at least 1 (0)");
}

TEST(Plan, GivenPrimitivesAreUsed) {
  Scene scene = load_scene(find_scene("mug"));
  scene.primitives = {{Cylinder{0.052, 0.1}, translation({0, 0, 0.05})}};
  const PlanResult result =
      plan(compile(std::move(scene)), few_candidates(), RunContext{.threads = 2});
  ASSERT_EQ(result.primitives.size(), 1U);
  EXPECT_FALSE(result.solids);
  EXPECT_EQ(result.stages.front().what, PlanCount::primitives_given);
  EXPECT_EQ(name_of(result.stages.front().what), "primitives given");
}

TEST(Plan, OfAnObjectTooLargeSaysBothSizes) {
  Scene scene;
  scene.object = make_graspable("crate", make_box(Vector3(1, 1, 1)), Material::wood);
  scene.hand = find_robot("franka_hand");
  const CompiledScene compiled = compile(std::move(scene));
  const PlanResult result = plan(compiled);
  EXPECT_EQ(result.status, PlanStatus::object_too_large);
  EXPECT_NEAR(result.smallest_width, 1.0, 1e-3);
  EXPECT_DOUBLE_EQ(result.largest_opening, 0.08);
  EXPECT_TRUE(result.grasps.empty());
  EXPECT_EQ(result.untested, 0);
  EXPECT_EQ(no_candidates_text(compiled, result),
            "crate: no grasp to try with hand franka_hand: the smallest size to close on is 1000 "
            "mm, the hand opens to 80 mm");
}

}  // namespace
}  // namespace prehend
