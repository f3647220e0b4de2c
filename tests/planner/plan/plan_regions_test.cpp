// Plans of objects with regions that hands must keep out of, or had better touch.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "planner/results/grasps_file.h"
#include "sim/scene/scene_file.h"
#include "tests/support/colored_stick.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// The upper half of a stick along z.
SurfaceRegion upper_half() {
  SurfaceRegion region;
  region.inside = {Box{{0.1, 0.1, 0.1}}, translation({0.0, 0.0, 0.05})};
  return region;
}

Scene stick() { return test::scene_with(find_robot("parallel_jaw"), make_box({0.03, 0.04, 0.15})); }

PlanOptions few_trials() {
  PlanOptions options;
  options.search.trials = 120;
  options.rank.top = 40;
  options.volumes = false;
  return options;
}

bool is_above(const GraspContact& contact) { return contact.point.position.z() >= -2e-4; }

TEST(PlanRegions, NoGraspTouchesWhatHandsMustKeepOutOf) {
  Scene scene = stick();
  scene.keep_out.push_back(upper_half());
  const PlanResult result = plan(compile(std::move(scene)), few_trials());
  ASSERT_FALSE(result.grasps.empty());
  for (const ScoredGrasp& grasp : result.grasps) {
    EXPECT_TRUE(std::none_of(grasp.trial.contacts.begin(), grasp.trial.contacts.end(), is_above));
  }
}

TEST(PlanRegions, WhereNothingElseCanBeTouchedTheAdviceSaysSo) {
  Scene scene = stick();
  SurfaceRegion all = upper_half();
  all.inside = {Box{{0.1, 0.1, 0.2}}};
  scene.keep_out.push_back(all);
  const CompiledScene compiled = compile(std::move(scene));
  const PlanResult result = plan(compiled, few_trials());
  EXPECT_EQ(result.status, PlanStatus::no_candidates);
  ASSERT_FALSE(result.advice.empty());
  EXPECT_EQ(result.advice.front().hint, Hint::keep_out);
  EXPECT_NE(no_candidates_text(compiled, result).find("parts of the object to keep out of"),
            std::string::npos);
}

TEST(PlanRegions, ATrialThatTouchesItEndsSo) {
  Scene scene = stick();
  const PlanResult found = plan(compile(scene), few_trials());
  scene.keep_out.push_back(upper_half());
  const CompiledScene compiled = compile(std::move(scene));
  std::vector<Candidate> candidates;
  for (const ScoredGrasp& grasp : found.grasps) candidates.push_back(grasp.candidate);
  EvaluateOptions options;
  options.trial.back_off_tries = 0;
  options.volumes = 0;
  const PlanResult judged = evaluate(compiled, candidates, options);
  int kept_out = 0;
  for (const ScoredGrasp& grasp : judged.grasps) {
    const auto& contacts = grasp.trial.contacts;
    const bool touches = std::any_of(contacts.begin(), contacts.end(), is_above);
    EXPECT_EQ(grasp.trial.outcome == Outcome::keep_out, touches);
    if (touches) ++kept_out;
  }
  EXPECT_GT(kept_out, 0);
  EXPECT_EQ(judged.outcomes[Outcome::keep_out], kept_out);
}

TEST(PlanRegions, GraspsOfPreferredRegionsComeFirst) {
  Scene scene = stick();
  scene.preferred.push_back(upper_half());
  const CompiledScene compiled = compile(std::move(scene));
  const PlanResult result = plan(compiled, few_trials());
  int preferred = 0;
  for (std::size_t i = 0; i < result.grasps.size(); ++i) {
    const Trial& trial = result.grasps[i].trial;
    const bool all = std::all_of(trial.contacts.begin(), trial.contacts.end(), is_above);
    EXPECT_EQ(trial.preferred, all);
    if (trial.preferred) ++preferred;
    if (i == 0) continue;
    EXPECT_FALSE(trial.preferred && !result.grasps[i - 1].trial.preferred) << i;
  }
  EXPECT_GT(preferred, 0);
  EXPECT_LT(preferred, static_cast<int>(result.grasps.size()));
}

// The stick of two colours: all contacts are on the one that is allowed, or preferred.
TEST(PlanRegions, OfColoursSayWhereGraspsHold) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "two_colors.ply";
  std::ofstream(file) << test::colored_stick();
  for (const bool keep_lower : {false, true}) {
    SurfaceRegion kept_out;
    kept_out.color = ColorRange{*color_in_text(keep_lower ? test::kUpperColor : test::kLowerColor)};
    const Scene scene =
        load_scene(file, {.hand = "parallel_jaw", .choice = {.keep_out = {kept_out}}});
    const PlanResult result = plan(compile(scene), few_trials());
    ASSERT_FALSE(result.grasps.empty());
    for (const ScoredGrasp& grasp : result.grasps) {
      for (const GraspContact& contact : grasp.trial.contacts) {
        EXPECT_GT((keep_lower ? -1.0 : 1.0) * contact.point.position.z(), 0.0);
      }
    }
  }
}

TEST(PlanRegions, AreTheSameOnAnyNumberOfThreads) {
  Scene scene = stick();
  scene.preferred.push_back(upper_half());
  SurfaceRegion end = upper_half();
  end.inside = {Box{{0.1, 0.1, 0.02}}, translation({0.0, 0.0, -0.07})};
  scene.keep_out.push_back(end);
  const CompiledScene compiled = compile(std::move(scene));
  RunRecord record;
  record.options = few_trials();
  const auto text = [&](int threads) {
    return grasps_json(compiled, plan(compiled, record.options, {.threads = threads}), record);
  };
  EXPECT_EQ(text(1), text(2));
}

}  // namespace
}  // namespace prehend
