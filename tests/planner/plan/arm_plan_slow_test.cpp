// The library's scenes with an arm, planned with paths, every path judged by other means than those
// that made it.
#include <algorithm>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "planner/plan/run_trials.h"
#include "planner/results/grasps_file.h"
#include "primitives/decompose.h"
#include "sim/base/parallel/parallel.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/proximity.h"
#include "tests/support/judge_path.h"
#include "tests/support/library_scenes.h"

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

PlanOptions options_of(PathPlanner planner, int top) {
  PlanOptions options;
  options.rank.top = top;
  options.paths.emplace();
  options.paths->transfer.planner = planner;
  return options;
}

class ArmPlan : public testing::TestWithParam<Case> {};

TEST_P(ArmPlan, EveryPathHoldsBeforeAnIndependentJudge) {
  const CompiledScene scene = test::compiled_library_scene(GetParam().scene);
  PlanOptions options = options_of(GetParam().planner, GetParam().top);
  options.search.trials = GetParam().candidates;
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
                    Case{"Shelf", "shelf", PathPlanner::rrt_connect, 40, 800, 3},
                    Case{"LivingRoom", "living_room", PathPlanner::rrt_connect, 20, 250, 5},
                    Case{"MugRoadmap", "mug_on_table", PathPlanner::roadmap, 40, 800, 25},
                    Case{"MugStar", "mug_on_table", PathPlanner::rrt_star, 20, 800, 15}),
    [](const auto& one) { return std::string(one.param.label); });

PlanResult plan_one(const CompiledScene& scene) {
  PlanOptions options = options_of(PathPlanner::rrt_connect, 1);
  options.search.trials = 200;
  return plan(scene, options);
}

// A judge that finds nothing wrong must be able to: one good path, spoilt in one way at a time.
class SpoiltPath : public testing::Test {
 protected:
  struct Good {
    CompiledScene scene = test::compiled_library_scene("mug_on_table");
    PlanResult result = plan_one(scene);
  };
  static const Good& good() {
    static const Good kGood;
    return kGood;
  }

  void SetUp() override {
    ASSERT_FALSE(good().result.grasps.empty());
    grasp_ = good().result.grasps.front();
    ASSERT_TRUE(grasp_.path.has_value());
  }

  Judgement judged(const test::Surroundings& around) const {
    return test::PathJudge(scene_, machine_, around, grasp_).judge();
  }
  Judgement judged() const { return judged(test::Surroundings(scene_)); }

  std::size_t middle() const { return grasp_.path->times.size() / 4; }

  const Scene& scene_ = good().scene.scene;
  const test::Machine machine_ = test::Machine(scene_);
  ScoredGrasp grasp_;
};

TEST_F(SpoiltPath, IsGoodAsItIs) { EXPECT_TRUE(judged().faults.empty()); }

TEST_F(SpoiltPath, ABoxOnItsWayIsSeen) {
  test::Posture posture;
  for (std::size_t j = 0; j < grasp_.path->joints.size(); ++j) {
    posture[grasp_.path->joints[j]] = grasp_.path->positions[middle()][j];
  }
  const Pose X_WH(machine_.hand_base(machine_.frames(posture)));
  test::Surroundings around(scene_);
  around.add("box", test::soup(make_box({0.01, 0.01, 0.2}), X_WH));
  EXPECT_GT(judged(around).collisions, 0);
}

TEST_F(SpoiltPath, AJointThatJumpsIsSeen) {
  grasp_.path->velocities[middle()][1] += 2.0;
  EXPECT_FALSE(judged().faults.empty());
}

TEST_F(SpoiltPath, HasteIsSeen) {
  for (double& time : grasp_.path->times) time *= 0.5;
  EXPECT_FALSE(judged().faults.empty());
}

TEST_F(SpoiltPath, AnApproachBesideTheLineIsSeen) {
  const auto segment = std::find_if(grasp_.path->segments.begin(), grasp_.path->segments.end(),
                                    [](const auto& s) { return s.name == "approach"; });
  ASSERT_NE(segment, grasp_.path->segments.end());
  const auto& approach = *segment;
  grasp_.path->positions[static_cast<std::size_t>((approach.first + approach.last) / 2)][0] += 1e-4;
  EXPECT_FALSE(judged().faults.empty());
}

TEST_F(SpoiltPath, ALiftToTheSideIsSeen) {
  const auto& last = grasp_.path->segments[grasp_.path->segments.size() - 2];
  ASSERT_EQ(last.name, "lift");
  grasp_.path->positions[static_cast<std::size_t>((last.first + last.last) / 2)][0] += 1e-3;
  EXPECT_FALSE(judged().faults.empty());
}

// Where the object comes by, but neither hand nor arm.
TEST_F(SpoiltPath, ABoxInTheWayOfTheObjectIsSeen) {
  const auto& last = grasp_.path->segments.back();
  ASSERT_EQ(last.name, "retreat");
  const auto sample = static_cast<std::size_t>(last.first + 1);
  test::Posture posture;
  for (std::size_t j = 0; j < grasp_.path->joints.size(); ++j) {
    posture[grasp_.path->joints[j]] = grasp_.path->positions[sample][j];
  }
  const Pose X_WH(machine_.hand_base(machine_.frames(posture)));
  const Pose X_WO = X_WH * grasp_.trial.X_OH.inverse();
  test::Surroundings around(scene_);
  const Bounds box = bounds(scene_.object.mesh);
  around.add("box", test::soup(make_box({0.2, 0.2, 0.004}),
                               X_WO * translation({0.0, 0.0, box.lower.z() + 0.004})));
  EXPECT_GT(judged(around).collisions, 0);
}

int count_of(const PlanResult& result, Outcome outcome) { return result.outcomes[outcome]; }

// Every candidate ends in one outcome; what was blocked has somebody to blame.
void expect_accounted_for(const PlanResult& result) {
  int tried = 0;
  for (const int count : result.outcomes.entries) tried += count;
  const auto candidates =
      std::find_if(result.stages.begin(), result.stages.end(),
                   [](const StageCount& stage) { return stage.what == PlanCount::candidates; });
  ASSERT_NE(candidates, result.stages.end());
  EXPECT_EQ(tried, candidates->count);
  int blocked = 0;
  for (const CollisionCount& blocker : result.blockers) {
    EXPECT_FALSE(blocker.by.empty());
    // What kept a stable grasp from a path did not block its trial.
    if (blocker.outcome != Outcome::no_path) blocked += blocker.count;
  }
  EXPECT_EQ(blocked, count_of(result, Outcome::hand_blocked) +
                         count_of(result, Outcome::approach_blocked) +
                         count_of(result, Outcome::arm_blocked));
}

// The same candidates with the obstacles and without those that `goes` names.
struct TriedTwice {
  std::vector<std::optional<Trial>> with;
  std::vector<std::optional<Trial>> without;
};

int stable_count(const std::vector<std::optional<Trial>>& trials) {
  return static_cast<int>(std::count_if(trials.begin(), trials.end(), [](const auto& trial) {
    return trial->outcome == Outcome::stable;
  }));
}

double best_epsilon(const std::vector<std::optional<Trial>>& trials) {
  double best = 0.0;
  for (const auto& trial : trials) {
    if (trial->outcome == Outcome::stable) best = std::max(best, trial->epsilon.lower);
  }
  return best;
}

// Whether a link of the hand in the grasp is as near to an obstacle as one that it stopped.
bool touches_an_obstacle(const CompiledScene& scene, const Trial& trial) {
  constexpr double kStopped = 1e-3;  // [m]
  const Pose X_OH = hand_in_scene(trial);
  std::vector<Pose> X_HL;
  link_poses(scene.scene.hand, trial.joints, X_HL);
  for (std::size_t l = 0; l < X_HL.size(); ++l) {
    for (const PlacedBody& obstacle : scene.obstacles()) {
      const Pose X_BL = obstacle.X_RB.inverse() * X_OH * X_HL[l];
      if (find_gap(obstacle.mesh, scene.links[l].mesh, X_BL).lower < kStopped) return true;
    }
  }
  return false;
}

// A search goes other ways where there are other obstacles, so the same candidates are compared.
// One that holds beside the obstacles holds without them and is the same grasp, unless an obstacle
// stopped the hand or a finger.
template <typename Goes>
void expect_fewer_grasps_with(Scene scene, const Goes& goes) {
  const CompiledScene with = compile(scene);
  const auto primitives = decompose(scene.object.mesh).primitives;
  std::vector<Candidate> candidates;
  for (ProposedGrasp& grasp : propose_grasps(with, primitives, 1500).grasps) {
    candidates.push_back(std::move(grasp.candidate));
  }
  std::erase_if(scene.obstacles, goes);
  // Where a hand that backs off ends depends on what stopped it before.
  const TrialOptions once{.back_off_tries = 0};
  TriedTwice two{run_trials(with, candidates, once), run_trials(compile(scene), candidates, once)};
  int same = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (two.with[i]->outcome != Outcome::stable) continue;
    EXPECT_NE(two.without[i]->outcome, Outcome::unreachable) << i;
    if (two.without[i]->outcome == Outcome::stable &&
        two.without[i]->epsilon.lower == two.with[i]->epsilon.lower) {
      ++same;
    } else {
      EXPECT_TRUE(touches_an_obstacle(with, *two.with[i])) << i;
    }
  }
  std::cout << stable_count(two.with) << " hold with the obstacles, the best with epsilon "
            << best_epsilon(two.with) << ", " << stable_count(two.without) << " and "
            << best_epsilon(two.without) << " without; the same: " << same << "\n";
  EXPECT_GT(stable_count(two.with), 0);
  EXPECT_GT(stable_count(two.without), stable_count(two.with));
  EXPECT_GT(same, 0);
  EXPECT_GE(best_epsilon(two.without), best_epsilon(two.with));
}

bool is_shelf(const StaticBody& body) { return body.name == "shelf"; }

TEST(ArmPlanObstacles, TheShelfTakesGraspsAway) {
  expect_fewer_grasps_with(load_scene(test::library_scene("shelf")), is_shelf);
}

TEST(ArmPlanObstacles, TheClutterTakesGraspsAway) {
  expect_fewer_grasps_with(
      load_scene(test::library_scene("cluttered_table")),
      [](const StaticBody& body) { return body.name != "table" && body.name != "floor"; });
}

// Six boards around the object, `clearance` away.
StaticBody crate_around(const GraspableBody& object, double clearance) {
  constexpr double kBoard = 0.004;
  const Bounds box = bounds(transformed(object.mesh, object.X_WO));
  const Vector3 inner = box.size() + Vector3::Constant(2.0 * clearance);
  StaticBody crate;
  crate.name = "crate";
  for (int axis = 0; axis < 3; ++axis) {
    Vector3 size = inner + Vector3::Constant(2.0 * kBoard);
    size[axis] = kBoard;
    for (const double side : {-1.0, 1.0}) {
      Vector3 at = box.center();
      at[axis] += side * 0.5 * (inner[axis] + kBoard);
      append(crate.mesh, transformed(make_box(size), translation(at)));
    }
  }
  return crate;
}

TEST(ArmPlanObstacles, NothingIsGraspedInAClosedCrate) {
  for (const char* name : {"mug_on_table", "shelf"}) {
    Scene scene = load_scene(test::library_scene(name));
    scene.obstacles.push_back(crate_around(scene.object, 0.003));
    const PlanResult result = plan(compile(scene), options_of(PathPlanner::rrt_connect, 5));
    EXPECT_TRUE(result.grasps.empty()) << name;
    expect_accounted_for(result);
    EXPECT_EQ(count_of(result, Outcome::stable), 0) << name;
    EXPECT_EQ(count_of(result, Outcome::not_force_closure), 0) << name;
    const auto crate =
        std::find_if(result.blockers.begin(), result.blockers.end(),
                     [](const CollisionCount& blocker) { return blocker.by == "crate"; });
    EXPECT_NE(crate, result.blockers.end()) << name;
  }
}

// With searches that are given up at once.
TEST(ArmPlanObstacles, WhatWasInTheWayOfPathsIsCounted) {
  PlanOptions options = options_of(PathPlanner::rrt_connect, 5);
  options.search.trials = 300;
  options.paths->transfer.max_iterations = 1;
  const PlanResult result = plan(test::compiled_library_scene("shelf"), options);
  expect_accounted_for(result);
  int named = 0;
  for (const Tried& tried : result.tried) {
    if (tried.outcome == Outcome::no_path) named += int{!tried.collision_of.by.empty()};
  }
  EXPECT_GT(named, 0);
  int counted = 0;
  for (const CollisionCount& blocker : result.blockers) {
    if (blocker.outcome == Outcome::no_path) counted += blocker.count;
  }
  EXPECT_EQ(counted, named);
}

std::string planned_text(const CompiledScene& scene, PathPlanner planner, int threads) {
  RunRecord record;
  record.options = options_of(planner, 3);
  RunContext context;
  context.threads = threads;
  const PlanResult result = plan(scene, record.options, context);
  EXPECT_EQ(result.grasps.size(), 3U);
  for (const ScoredGrasp& grasp : result.grasps) EXPECT_TRUE(grasp.path.has_value());
  return grasps_json(scene, result, record);
}

TEST(ArmPlanRepeats, OnAnyNumberOfThreads) {
  for (const char* name : {"mug_on_table", "shelf"}) {
    const CompiledScene scene = test::compiled_library_scene(name);
    EXPECT_EQ(planned_text(scene, PathPlanner::rrt_connect, 1),
              planned_text(scene, PathPlanner::rrt_connect, 2))
        << name;
  }
}

TEST(ArmPlanRepeats, WithEveryPlanner) {
  const CompiledScene scene = test::compiled_library_scene("mug_on_table");
  for (const PathPlanner planner : {PathPlanner::roadmap, PathPlanner::rrt_star}) {
    EXPECT_EQ(planned_text(scene, planner, 1), planned_text(scene, planner, 2)) << name_of(planner);
  }
}

}  // namespace
}  // namespace prehend
