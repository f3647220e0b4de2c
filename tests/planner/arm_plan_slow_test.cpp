// The library's scenes with an arm, planned with paths, every path judged by other means than those
// that made it.
#include <iostream>

#include <gtest/gtest.h>

#include "planner/grasps_file.h"
#include "planner/plan.h"
#include "tests/planner/judge_path.h"
#include "tests/scene/library_scenes.h"

namespace prehend {
namespace {

using test::Judgement;

struct Case {
  const char* label;
  const char* scene;
  PathPlanner planner;
  int top;
  int candidates;
  int least;  // grasps with paths
};

void PrintTo(const Case& one, std::ostream* stream) { *stream << one.label; }

PlanOptions options_of(PathPlanner planner, int top, int threads = 0) {
  PlanOptions options;
  options.rank.top = top;
  options.trials.threads = threads;
  options.paths.emplace();
  options.paths->transfer.planner = planner;
  return options;
}

class ArmPlan : public testing::TestWithParam<Case> {};

TEST_P(ArmPlan, EveryPathHoldsBeforeAnIndependentJudge) {
  const CompiledScene scene = test::compiled_library_scene(GetParam().scene);
  PlanOptions options = options_of(GetParam().planner, GetParam().top);
  options.candidates.max_candidates = GetParam().candidates;
  const PlanResult result = plan(scene, options);
  EXPECT_GE(static_cast<int>(result.grasps.size()), GetParam().least);
  const test::Machine machine(scene.scene);
  const test::Surroundings around(scene.scene);
  std::vector<Judgement> judgements(result.grasps.size());
  for_each_in_parallel(judgements.size(), 0, [&](std::size_t i) {
    if (!result.grasps[i].path) return;
    judgements[i] = test::PathJudge(scene.scene, machine, around, result.grasps[i]).judge();
  });
  int postures = 0;
  for (std::size_t i = 0; i < judgements.size(); ++i) {
    EXPECT_TRUE(result.grasps[i].path.has_value()) << i;
    EXPECT_EQ(result.grasps[i].trial.outcome, Outcome::stable) << i;
    for (const std::string& fault : judgements[i].faults) ADD_FAILURE() << i << ": " << fault;
    EXPECT_EQ(judgements[i].collisions, 0) << i;
    EXPECT_GT(judgements[i].postures, 100) << i;
    postures += judgements[i].postures;
  }
  std::cout << GetParam().label << ": " << judgements.size() << " paths, " << postures
            << " postures\n";
}

INSTANTIATE_TEST_SUITE_P(
    Library, ArmPlan,
    testing::Values(Case{"Mug", "mug_on_table", PathPlanner::rrt_connect, 40, 800, 25},
                    Case{"Clutter", "cluttered_table", PathPlanner::rrt_connect, 40, 800, 8},
                    Case{"Shelf", "shelf", PathPlanner::rrt_connect, 40, 800, 20},
                    Case{"LivingRoom", "living_room", PathPlanner::rrt_connect, 20, 250, 5},
                    Case{"MugRoadmap", "mug_on_table", PathPlanner::roadmap, 20, 800, 15},
                    Case{"MugStar", "mug_on_table", PathPlanner::rrt_star, 20, 800, 15}),
    [](const auto& one) { return std::string(one.param.label); });

}  // namespace
}  // namespace prehend
