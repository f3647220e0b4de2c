#include "planner/results/datasets/set_candidates.h"

#include <gtest/gtest.h>

#include "planner/plan/plan_result.h"
#include "planner/results/datasets/set_scene.h"
#include "sim/scene/compiled_scene.h"
#include "tests/planner/results/datasets/sample_sets.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

// A cube with edges of two units, about the origin.
const std::string kCube =
    "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
    "f 1 3 2\nf 1 4 3\nf 5 6 7\nf 5 7 8\nf 1 2 6\nf 1 6 5\nf 2 3 7\nf 2 7 6\nf 3 4 8\nf 3 8 7\n"
    "f 4 1 5\nf 4 5 8\n";

GraspSet cube_set() {
  GraspSet set;
  set.object.scale = 0.02;
  set.object.mass = 0.125;
  set.hand = "panda";
  return set;
}

TEST(SetPreshape, IsTheNarrowestThatIsWideEnough) {
  Hand hand;
  for (const double width : {0.1, 0.04, 0.08, 0.08}) {
    hand.preshapes.emplace_back().max_width = width;
  }
  EXPECT_EQ(set_preshape(hand, {}), 0);
  EXPECT_EQ(set_preshape(hand, 0.01), 1);
  EXPECT_EQ(set_preshape(hand, 0.04), 1);
  EXPECT_EQ(set_preshape(hand, 0.05), 2);
  EXPECT_EQ(set_preshape(hand, 0.08), 2);
  EXPECT_EQ(set_preshape(hand, 0.09), 0);
  EXPECT_EQ(set_preshape(hand, 0.2), 0);
}

TEST(SetScene, FindsTheHandThatAPlatformOfItsNameCarries) {
  EXPECT_EQ(library_hand_called("panda"), "franka_hand");
  EXPECT_EQ(library_hand_called("franka_hand"), "franka_hand");
  EXPECT_EQ(library_hand_called("panda_arm"), "");
  EXPECT_EQ(library_hand_called("no such hand"), "");
  EXPECT_EQ(library_hand_called(""), "");
}

TEST(SetScene, HasTheObjectInItsSize) {
  GraspSet set = cube_set();
  const auto mesh = test::file_with(kCube, ".obj");
  set.object.file = "meshes/" + mesh.filename().string();  // beside the set, not in a folder
  const SetScene loaded = load_set_scene(set, mesh.parent_path() / "set.h5", {});
  EXPECT_TRUE(loaded.scaled);
  EXPECT_EQ(loaded.hand, "franka_hand");
  EXPECT_EQ(loaded.scene.hand.name, "franka_hand");
  EXPECT_TRUE(bounds(loaded.scene.object.mesh).size().isApprox(Vector3::Constant(0.04), 1e-12));
  EXPECT_EQ(loaded.scene.object.mass, 0.125);
  set.object.scale = 1.0;
  const SetScene same = load_set_scene(set, "set.h5", {.scene = mesh.string(), .unit = "cm"});
  EXPECT_FALSE(same.scaled);
  EXPECT_TRUE(bounds(same.scene.object.mesh).size().isApprox(Vector3::Constant(0.02), 1e-12));
  EXPECT_EQ(same.unit, "cm");
}

TEST(SetScene, SaysWhatIsMissing) {
  GraspSet set = cube_set();
  set.object.file = "no/such.obj";
  const auto refused = [&](const SetSceneSource& asked) {
    return test::refusal_of([&] { (void)load_set_scene(set, "set.h5", asked); });
  };
  EXPECT_EQ(refused({}).field(), "object.file");
  const auto mesh = test::file_with(kCube, ".obj");
  set.hand = "gripper of nobody";
  EXPECT_EQ(refused({.scene = mesh.string()}).field(), "gripper.type");
  set.hand = "";
  EXPECT_NE(refused({.scene = mesh.string()}).problem().find("--hand"), std::string::npos);
}

TEST(SetCandidates, AreTriedWhereTheyAreWithTheHandOpen) {
  Random random(2);
  GraspSet set = cube_set();
  set.grasps.resize(3);
  for (GraspSetEntry& grasp : set.grasps) grasp.X_OH = random.pose(0.1);
  const auto mesh = test::file_with(kCube, ".obj");
  const CompiledScene scene =
      compile(load_set_scene(set, "set.h5", {.scene = mesh.string()}).scene);
  const std::vector<Candidate> candidates = set_candidates(set, scene);
  ASSERT_EQ(candidates.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(candidates[i].X_OH.matrix(), set.grasps[i].X_OH.matrix());
    EXPECT_EQ(candidates[i].preshape, 0);
    EXPECT_EQ(candidates[i].approach_distance, 0.0);
    // The hand's approach is its z axis.
    EXPECT_TRUE(candidates[i].approach_O.isApprox(set.grasps[i].X_OH.linear().col(2), 1e-12));
  }
}

TEST(LabelAgreement, CountsWhatHoldsThereAndHere) {
  const std::vector<bool> labels = {true, true, false, false, false, true};
  const auto tried = [](int candidate, Outcome outcome) {
    Tried trial;
    trial.candidate = candidate;
    trial.outcome = outcome;
    return trial;
  };
  // The last but one was not tried.
  const LabelAgreement agreement =
      compare_labels(labels, {tried(0, Outcome::stable), tried(1, Outcome::hand_blocked),
                              tried(2, Outcome::stable), tried(3, Outcome::no_contact),
                              tried(5, Outcome::stable)});
  EXPECT_EQ(agreement.both, 2);
  EXPECT_EQ(agreement.there_only, 1);
  EXPECT_EQ(agreement.here_only, 1);
  EXPECT_EQ(agreement.neither, 1);
  EXPECT_EQ(agreement_text(agreement),
            "labels of the file: 3 of 5 agree (60.0 %); held there and here 2, there only 1, here "
            "only 1, neither 1");
}

TEST(LabelAgreement, OfNothing) {
  EXPECT_NE(agreement_text({}).find("0 of 0 agree (0.0 %)"), std::string::npos);
}

}  // namespace
}  // namespace prehend
