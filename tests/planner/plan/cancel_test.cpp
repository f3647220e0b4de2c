// What is left of long calls that are cancelled, and that a context changes nothing else.
#include <filesystem>
#include <iterator>

#include <gtest/gtest.h>

#include "planner/plan/path/check_path.h"
#include "planner/plan/plan.h"
#include "planner/results/grasps_file.h"
#include "sim/shape/basic_shapes.h"
#include "sim/trial/approach_line.h"
#include "sim/trial/run_trial.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

const CompiledScene& mug() {
  static const CompiledScene scene = test::compiled_library_scene("mug");
  return scene;
}

const CompiledScene& mug_on_table() {
  static const CompiledScene scene = test::compiled_library_scene("mug_on_table");
  return scene;
}

// The first of the sequence, whatever holds.
PlanOptions few_candidates(int count) {
  PlanOptions options;
  options.search.trials = count;
  options.search.local_fraction = 0.0;
  options.search.settled = 1.0;
  return options;
}

RunContext cancelled_beforehand() {
  RunContext context;
  context.cancellation.request();
  return context;
}

// Requests its own cancellation once `done` pieces of `stage` are done.
RunContext cancelled_after(Stage stage, int done, int threads) {
  RunContext context = RunContext{.threads = threads};
  context.progress = [stage, done, flag = context.cancellation](const Progress& progress) {
    if (progress.stage == stage && progress.done == done) flag.request();
  };
  return context;
}

std::vector<Candidate> proposed(const CompiledScene& scene, const PlanOptions& options) {
  const auto primitives = decompose(scene.scene.object.mesh, options.primitives).primitives;
  std::vector<Candidate> candidates;
  for (const ProposedGrasp& grasp :
       propose_grasps(scene, primitives, index(options.search.trials)).grasps) {
    candidates.push_back(grasp.candidate);
  }
  return candidates;
}

TEST(Cancellation, CopiesShareTheFlag) {
  const Cancellation flag;
  const Cancellation copy = flag;
  const Cancellation other;
  EXPECT_NO_THROW(copy.check());
  flag.request();
  EXPECT_TRUE(copy.requested());
  EXPECT_THROW(copy.check(), Cancelled);
  EXPECT_FALSE(other.requested());
}

TEST(CancelledPlan, RanksExactlyTheTrialsThatWereFinished) {
  const PlanOptions options = few_candidates(40);
  std::vector<Candidate> candidates = proposed(mug(), options);
  ASSERT_EQ(candidates.size(), 40U);
  TrialOptions once;
  once.back_off_tries = 0;
  for (const int k : {1, 17, 39}) {
    const PlanResult result = plan(mug(), options, cancelled_after(Stage::trials, k, 1));
    EXPECT_EQ(result.status, PlanStatus::cancelled);
    EXPECT_EQ(result.untested, 40 - k);
    ASSERT_EQ(result.tried.size(), static_cast<std::size_t>(k));
    std::vector<Trial> first;
    for (int i = 0; i < k; ++i) {
      EXPECT_EQ(result.tried[index(i)].candidate, i);
      first.push_back(run_trial(mug(), candidates[static_cast<std::size_t>(i)], once));
    }
    const std::vector<std::size_t> order = rank(first, options.rank);
    ASSERT_EQ(result.grasps.size(), order.size()) << k;
    for (std::size_t r = 0; r < order.size(); ++r) {
      EXPECT_EQ(result.grasps[r].tried, static_cast<int>(order[r]));
      EXPECT_EQ(result.grasps[r].trial.X_OH.matrix(), first[order[r]].X_OH.matrix());
      EXPECT_EQ(result.grasps[r].trial.epsilon.lower, first[order[r]].epsilon.lower);
      EXPECT_FALSE(result.grasps[r].volume.has_value());
    }
  }
}

TEST(CancelledPlan, OnTwoThreadsEveryCandidateIsTriedOrCountedAsUntested) {
  PlanOptions options = few_candidates(40);
  options.free_closing = 0;  // a later stage, which changes outcomes
  const PlanResult all = plan(mug(), options);
  const PlanResult some = plan(mug(), options, cancelled_after(Stage::trials, 10, 2));
  EXPECT_EQ(some.status, PlanStatus::cancelled);
  EXPECT_GE(some.tried.size(), 10U);
  EXPECT_GT(some.untested, 0);
  EXPECT_EQ(some.tried.size() + static_cast<std::size_t>(some.untested), all.tried.size());
  for (const Tried& tried : some.tried) {
    EXPECT_EQ(tried.outcome, all.tried[index(tried.candidate)].outcome);
  }
}

TEST(CancelledPlan, IsAFileThatSaysSo) {
  const PlanResult result = plan(mug(), few_candidates(40), cancelled_after(Stage::trials, 30, 1));
  const auto json = nlohmann::json::parse(grasps_json(mug(), result, {}));
  EXPECT_EQ(json["status"], "cancelled");
  EXPECT_EQ(json["untested"], 10);
  ASSERT_FALSE(json["grasps"].empty());
  EXPECT_FALSE(json["grasps"][0].contains("volume"));
  const auto whole = nlohmann::json::parse(grasps_json(mug(), plan(mug(), few_candidates(5)), {}));
  EXPECT_FALSE(whole.contains("status"));
  EXPECT_FALSE(whole.contains("untested"));
}

TEST(CancelledPlan, KeepsThePathsThatWereFound) {
  PlanOptions options = few_candidates(80);
  options.rank.top = 3;
  options.paths.emplace();
  const PlanResult all = plan(mug_on_table(), options, RunContext{.threads = 2});
  ASSERT_EQ(all.grasps.size(), 3U);
  for (const int found : {1, 2}) {
    const PlanResult some = plan(mug_on_table(), options, cancelled_after(Stage::paths, found, 1));
    EXPECT_EQ(some.status, PlanStatus::cancelled);
    EXPECT_EQ(some.untested, 0);
    ASSERT_EQ(some.grasps.size(), static_cast<std::size_t>(found));
    for (std::size_t i = 0; i < some.grasps.size(); ++i) {
      ASSERT_TRUE(some.grasps[i].path.has_value());
      EXPECT_EQ(some.grasps[i].path->positions, all.grasps[i].path->positions);
    }
  }
}

TEST(CancelledPlan, BeforeThePathsHasTheBestGraspsWithoutPaths) {
  PlanOptions options = few_candidates(80);
  options.rank.top = 3;
  options.paths.emplace();
  const PlanResult some = plan(mug_on_table(), options, cancelled_after(Stage::trials, 79, 1));
  EXPECT_EQ(some.status, PlanStatus::cancelled);
  ASSERT_EQ(some.grasps.size(), 3U);
  for (const ScoredGrasp& grasp : some.grasps) EXPECT_FALSE(grasp.path.has_value());
}

TEST(CancelledPlan, BeforehandFindsNothingAndDoesNotThrow) {
  const PlanResult result = plan(mug(), few_candidates(40), cancelled_beforehand());
  EXPECT_EQ(result.status, PlanStatus::cancelled);
  EXPECT_TRUE(result.primitives.empty());
  EXPECT_TRUE(result.grasps.empty());
}

TEST(CancelledEvaluation, SaysWhichCandidatesWereTried) {
  const std::vector<Candidate> candidates = proposed(mug(), few_candidates(20));
  const PlanResult some = evaluate(mug(), candidates, {}, cancelled_after(Stage::trials, 7, 1));
  EXPECT_EQ(some.status, PlanStatus::cancelled);
  EXPECT_EQ(some.untested, 13);
  ASSERT_EQ(some.grasps.size(), 7U);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(some.tried[i].candidate, static_cast<int>(i));
  const PlanResult none = evaluate(mug(), candidates, {}, cancelled_beforehand());
  EXPECT_EQ(none.status, PlanStatus::cancelled);
  EXPECT_EQ(none.untested, 20);
  EXPECT_TRUE(none.grasps.empty());
}

TEST(Evaluation, OfNothingHasNothingToTry) {
  const PlanResult result = evaluate(mug(), {});
  EXPECT_EQ(result.status, PlanStatus::no_candidates);
  EXPECT_EQ(result.untested, 0);
}

// Every call without a partial result.
TEST(CancelledBeforehand, LongCallsThrow) {
  const RunContext context = cancelled_beforehand();
  const CompiledScene& scene = mug_on_table();
  const CompiledArm& arm = *scene.arm;
  const PlanOptions options = few_candidates(80);
  const PlanResult planned = plan(scene, options);
  ASSERT_FALSE(planned.grasps.empty());
  const ScoredGrasp& best = planned.grasps.front();
  const HandLine line = approach_line(scene, best.candidate, best.trial);
  EXPECT_THROW(compile(mug().scene, context), Cancelled);
  EXPECT_THROW(decompose(scene.scene.object.mesh, {}, context), Cancelled);
  EXPECT_THROW(propose_grasps(scene, planned.primitives, 100, {}, context), Cancelled);
  EXPECT_THROW(run_trial(scene, best.candidate, {}, context), Cancelled);
  EXPECT_THROW(run_trial(mug(), proposed(mug(), options).front(), {}, context), Cancelled);
  EXPECT_THROW(find_reaches(arm, line, 3, {}, context), Cancelled);
  EXPECT_THROW(find_reach(arm, line, {}, context), Cancelled);
  EXPECT_THROW(plan_grasp_path(scene, best.candidate, best.trial, {}, context), Cancelled);
  const Reach reach = find_reach(arm, line, {});
  ASSERT_EQ(reach.end, ReachEnd::reached);
  const Transfer transfer{arm.start, reach.line.front(), line.hand_joints};
  for (const PathPlanner planner :
       {PathPlanner::rrt_connect, PathPlanner::roadmap, PathPlanner::rrt_star}) {
    TransferOptions way;
    way.planner = planner;
    EXPECT_THROW(plan_transfer(arm, transfer, way, context), Cancelled);
  }
  const auto path = plan_grasp_path(scene, best.candidate, best.trial);
  ASSERT_TRUE(path.has_value());
  EXPECT_THROW(check_path(scene, path->motion, {}, context), Cancelled);
}

TEST(Context, DoesNotChangeTheResult) {
  const std::string bare = grasps_json(mug(), plan(mug(), few_candidates(30)), {});
  for (const int threads : {1, 2}) {
    int calls = 0;
    RunContext context = RunContext{.threads = threads};
    context.progress = [&](const Progress&) { ++calls; };
    EXPECT_EQ(grasps_json(mug(), plan(mug(), few_candidates(30), context), {}), bare);
    EXPECT_GE(calls, 30);
  }
}

TEST(Context, ProgressCountsEveryTrialOnce) {
  std::vector<int> done;
  RunContext context = RunContext{.threads = 2};
  context.progress = [&](const Progress& progress) {
    if (progress.stage == Stage::trials) done.push_back(progress.done);
  };
  const PlanResult result = plan(mug(), few_candidates(30), context);
  ASSERT_EQ(done.size(), 31U);
  for (std::size_t i = 0; i < done.size(); ++i) EXPECT_EQ(done[i], static_cast<int>(i));
}

TEST(Context, AnExceptionOfTheProgressCallEndsThePlan) {
  RunContext context = RunContext{.threads = 2};
  context.progress = [](const Progress& progress) {
    if (progress.stage == Stage::trials && progress.done == 3) throw std::range_error("enough");
  };
  EXPECT_THROW(plan(mug(), few_candidates(30), context), std::range_error);
}

std::ptrdiff_t threads_of_this_process() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/task"), {});
}

TEST(Context, CancelledPlansLeaveNoThreads) {
  (void)plan(mug(), few_candidates(30),
             RunContext{.threads = 2});  // starts the workers of the pool
  const std::ptrdiff_t before = threads_of_this_process();
  for (int k = 0; k < 10; ++k) {
    (void)plan(mug(), few_candidates(30), cancelled_after(Stage::trials, k, 2));
  }
  EXPECT_LE(threads_of_this_process(), before);
}

}  // namespace
}  // namespace prehend
