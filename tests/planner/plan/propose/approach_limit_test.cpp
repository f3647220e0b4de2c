// Limits to the direction of approach: their words, what they allow, and what plans make of them.
#include "planner/plan/propose/approach_limit.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "planner/plan/propose/candidates.h"
#include "sim/base/random.h"
#include "tests/support/library_scenes.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::string refusal(const std::string& words) {
  return test::refusal_of([&] { (void)approach_limit(words); }).what();
}

// The mug, turned in the world.
CompiledScene turned_mug() {
  Scene scene = load_scene(test::library_scene("mug"));
  scene.object.X_WO = Pose(Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -0.5).normalized()));
  return compile(std::move(scene));
}

TEST(ApproachLimit, WordsStateFrameDirectionAndAngle) {
  const ApproachLimit down = approach_limit("down");
  EXPECT_EQ(down.direction, Vector3(0.0, 0.0, -1.0));
  EXPECT_NEAR(down.angle, 30.0 * kDegree, 1e-15);
  EXPECT_EQ(down.frame, ApproachFrame::world);
  const ApproachLimit own = approach_limit("object:1,-2.5,0/0.25rad");
  EXPECT_EQ(own.direction, Vector3(1.0, -2.5, 0.0));
  EXPECT_EQ(own.angle, 0.25);
  EXPECT_EQ(own.frame, ApproachFrame::object);
  EXPECT_EQ(approach_limit("world:+y/180deg").direction, Vector3::UnitY());
}

TEST(ApproachLimit, ItsTextStatesTheSame) {
  for (const char* words : {"down/30deg", "up/5deg", "object:-x/0deg", "object:1,0,1/15deg"}) {
    EXPECT_EQ(approach_text(approach_limit(words)), words);
  }
}

TEST(ApproachLimit, OtherWordsAreRefused) {
  const std::string direction = "the direction must be down, up, ";
  const std::string angle = "the angle must be 0deg to 180deg";
  for (const char* words : {"", "sideways", "1,0", "1,0,0,0", "1,nan,0", "1,0,inf", "Down"}) {
    EXPECT_EQ(refusal(words).find(direction), 0U) << words << ": " << refusal(words);
  }
  for (const char* words : {"down/", "down/30", "down/181deg", "down/-1deg", "down/nandeg",
                            "down/30deg/2deg", "down/deg"}) {
    EXPECT_EQ(refusal(words).find(angle), 0U) << words << ": " << refusal(words);
  }
  EXPECT_EQ(refusal("0,0,0"), "the direction must not be zero (0,0,0)");
  EXPECT_EQ(refusal("hand:down"), "the frame before \":\" must be world or object (hand:down)");
}

TEST(ApproachLimit, AllowsWhatIsWithinTheAngleInItsFrame) {
  const CompiledScene scene = turned_mug();
  const Matrix3 R_WO = scene.scene.object.X_WO.linear();
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vector3 direction = random.direction();
    const double angle = random.uniform() * std::numbers::pi;
    const Vector3 asked_O = random.direction();
    const ApproachLimit own{3.0 * direction, angle, ApproachFrame::object};
    const double off = std::acos(asked_O.dot(direction));
    if (std::abs(off - angle) < 1e-6) continue;
    EXPECT_EQ(allows(own, scene, asked_O), off < angle);
    const ApproachLimit world{R_WO * direction, angle, ApproachFrame::world};
    EXPECT_EQ(allows(world, scene, asked_O), off < angle);
  }
}

TEST(ApproachLimit, OnlySuchCandidatesAreProposed) {
  const CompiledScene scene = turned_mug();
  const std::vector<Primitive> primitives = {{Cylinder{0.04, 0.1}}, {Sphere{0.03}}};
  for (const char* words : {"down/20deg", "object:+y/5deg", "up/179deg"}) {
    CandidateOptions options;
    options.approach = approach_limit(words);
    const Proposals proposals = propose_grasps(scene, primitives, 200, options);
    EXPECT_EQ(proposals.grasps.size(), 200U) << words;
    for (const ProposedGrasp& grasp : proposals.grasps) {
      ASSERT_TRUE(allows(*options.approach, scene, grasp.candidate.approach_O)) << words;
    }
  }
}

TEST(ApproachLimit, ProposalsEndWhereItAllowsNone) {
  const CompiledScene scene =
      test::compiled(find_robot("parallel_jaw"), make_box({0.03, 0.04, 0.05}));
  CandidateOptions options;
  options.approach = approach_limit("1,1,1/3deg");
  EXPECT_TRUE(propose_grasps(scene, {{Box{{0.03, 0.04, 0.05}}}}, 10, options).grasps.empty());
  // Within half a step of the directions of a face, but not within the angle.
  options.approach = approach_limit("0,0.1,-1/1deg");
  EXPECT_TRUE(propose_grasps(scene, {{Box{{0.03, 0.04, 0.05}}}}, 10, options).grasps.empty());
}

}  // namespace
}  // namespace prehend
