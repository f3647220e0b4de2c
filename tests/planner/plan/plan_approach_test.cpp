// Plans whose hands may come from some directions only.
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "planner/plan/plan.h"
#include "tests/support/library_scenes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

TEST(PlanApproach, EachGraspIsWithinTheLimit) {
  Scene turned = load_scene(test::library_scene("mug"));
  turned.object.X_WO = Pose(Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -0.5).normalized()));
  const CompiledScene scene = compile(std::move(turned));
  PlanOptions options;
  options.search.trials = 200;
  options.rank.top = 50;
  options.volumes = false;
  const ApproachLimit limit = approach_limit("down/25deg");
  options.candidates.approach = limit;
  const PlanResult result = plan(scene, options);
  ASSERT_FALSE(result.grasps.empty());
  const Vector3 approach_H = scene.scene.hand.hand->approach;
  const double least = std::cos(limit.angle) - 1e-9;
  for (const ScoredGrasp& grasp : result.grasps) {
    const Matrix3 R_WO = scene.scene.object.X_WO.linear();
    EXPECT_GE(-(R_WO * grasp.candidate.approach_O).z(), least);
    EXPECT_GE(-(R_WO * grasp.trial.X_OH.linear() * approach_H).z(), least);
  }
}

TEST(PlanApproach, APlanWithoutAnyCandidateSaysSo) {
  const CompiledScene scene =
      test::compiled(find_robot("parallel_jaw"), make_box({0.05, 0.05, 0.05}));
  PlanOptions options;
  options.candidates.approach = approach_limit("1,1,1/3deg");
  const PlanResult result = plan(scene, options);
  EXPECT_EQ(result.status, PlanStatus::no_candidates);
  ASSERT_FALSE(result.advice.empty());
  EXPECT_EQ(result.advice.front().hint, Hint::approach);
  EXPECT_NE(no_candidates_text(scene, result)
                .find("try another --approach than 1,1,1/3deg, from which nothing is proposed: "
                      "from all sides, "),
            std::string::npos);
}

}  // namespace
}  // namespace prehend
