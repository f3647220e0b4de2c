// Plans among obstacles that the hand keeps away from.
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/proximity.h"
#include "sim/trial/run_trial.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// A stick along z and another one beside it, 25 mm away.
Scene two_sticks(double apart) {
  Scene scene = test::scene_with(find_robot("parallel_jaw"), make_box({0.03, 0.04, 0.15}));
  add_obstacle(scene, "neighbour", make_box({0.03, 0.04, 0.15}), translation({0.055, 0.0, 0.0}));
  scene.obstacles.back().apart = apart;
  return scene;
}

PlanOptions trials_beside() {
  PlanOptions options;
  options.search.trials = 150;
  options.rank.top = 60;
  options.volumes = false;
  return options;
}

double gap_to_neighbour(const CompiledScene& scene, const Pose& X_OH,
                        const std::vector<double>& joints) {
  RobotPoses poses;
  robot_poses(scene.scene.hand, joints, poses);
  const PlacedBody& body = scene.obstacles().front();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t l = 0; l < scene.links.size(); ++l) {
    const Pose X_RL = body.X_RB.inverse() * X_OH * poses.X_BL[l];
    least = std::min(least, find_gap(body.mesh, scene.links[l].mesh, X_RL).lower);
  }
  return least;
}

// Over the way of the open hand and at the grasp.
double least_gap(const CompiledScene& scene, const ScoredGrasp& grasp) {
  const Candidate& candidate = grasp.candidate;
  std::vector<double> open;
  start_joints(scene.scene.hand, candidate, open);
  double least = gap_to_neighbour(scene, grasp.trial.X_OH, grasp.trial.joints);
  constexpr int kSamples = 40;
  for (int k = 0; k <= kSamples; ++k) {
    const double travel = grasp.trial.travel * k / kSamples;
    const Pose X_OH = translation(grasp.trial.overlap_shift -
                                  (candidate.approach_distance - travel) * candidate.approach_O) *
                      candidate.X_OH;
    least = std::min(least, gap_to_neighbour(scene, X_OH, open));
  }
  return least;
}

std::vector<double> gaps_of_grasps(double apart) {
  const CompiledScene scene = compile(two_sticks(apart));
  std::vector<double> gaps;
  for (const ScoredGrasp& grasp : plan(scene, trials_beside()).grasps) {
    gaps.push_back(least_gap(scene, grasp));
  }
  return gaps;
}

TEST(PlanApart, FingersMayEndAtAnObstacleThatTheyMayTouch) {
  const std::vector<double> gaps = gaps_of_grasps(0.0);
  ASSERT_FALSE(gaps.empty());
  EXPECT_LT(*std::min_element(gaps.begin(), gaps.end()), 0.004);
}

TEST(PlanApart, EveryGraspKeepsItsDistanceOnTheWayAndAtTheEnd) {
  for (const double apart : {0.004, 0.01}) {
    const std::vector<double> gaps = gaps_of_grasps(apart);
    ASSERT_FALSE(gaps.empty());
    EXPECT_GE(*std::min_element(gaps.begin(), gaps.end()), 0.95 * apart);
  }
}

TEST(PlanApart, WhereNothingIsThatFarTheObstacleIsNamed) {
  const CompiledScene scene = compile(two_sticks(0.5));
  const PlanResult result = plan(scene, trials_beside());
  EXPECT_TRUE(result.grasps.empty());
  EXPECT_NE(no_candidates_text(scene, result).find("neighbour"), std::string::npos)
      << no_candidates_text(scene, result);
}

}  // namespace
}  // namespace prehend
