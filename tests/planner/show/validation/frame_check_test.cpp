#include "planner/show/validation/frame_check.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "planner/show/validation/frame_guesses.h"
#include "sim/base/random.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"
#include "sim/shape/files/mesh_file.h"
#include "tests/support/published_grasps.h"
#include "tests/support/shared_data.h"

namespace prehend::test {
namespace {

constexpr double kFrankaReach = 0.10325;  // tool_reach of robots/franka_hand

CompiledScene box_scene(const Vector3& size) {
  return compile(
      make_scene(make_graspable("box", make_box(size), Material::plastic), "franka_hand"));
}

// The Franka hand grasps a flat box from all sides about its edge, the point between the fingertips
// up to 5 mm off the middle of the box.
ExecutedGrasps grasps_of_a_box(int count) {
  ExecutedGrasps truth{{{"box", box_scene({0.04, 0.04, 0.03})}}, {"-"}, {}};
  Random random(2);
  for (int i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * random.uniform();
    // The hand's approach (z) is level, it closes (along its y axis) along the z axis of the box.
    Matrix3 R;
    R.col(2) = Vector3(std::cos(turn), std::sin(turn), 0.0);
    R.col(1) = Vector3::UnitZ();
    R.col(0) = R.col(1).cross(R.col(2));
    Execution execution;
    execution.grasp.X_OH =
        pose_from(R, random.in_box(0.005)) * translation(Vector3(0.0, 0.0, -kFrankaReach));
    execution.grasp.preshape = 0;
    execution.label.lifted = i % 2 == 0;
    truth.executions.push_back(execution);
  }
  const Hand& hand = *truth.objects[0].scene.scene.hand.hand;
  if (std::abs(hand.closing.y()) < 0.5) {
    const Pose quarter(Eigen::AngleAxisd(0.5 * std::numbers::pi, Vector3::UnitZ()));
    for (Execution& execution : truth.executions) {
      execution.grasp.X_OH = execution.grasp.X_OH * quarter;
    }
  }
  return truth;
}

template <typename Change>
FrameCheck checked_after(ExecutedGrasps truth, const Change& change) {
  for (Execution& execution : truth.executions) {
    execution.grasp.X_OH = change(execution.grasp.X_OH);
  }
  return check_frames(truth);
}

TEST(FrameCheck, IsSilentWhereTheFramesAreRight) {
  const FrameCheck check = check_frames(grasps_of_a_box(40));
  EXPECT_EQ(check.grasps, 40);
  EXPECT_EQ(check.between(), 40);
  EXPECT_FALSE(check.suspicion);
  EXPECT_EQ(frame_text(check), "as given the object is between the fingers of 40 of 40 grasps");
}

TEST(FrameCheck, NamesTheOffsetOfTheToolsPoint) {
  const FrameCheck check = checked_after(grasps_of_a_box(40), [](const Pose& X_OH) {
    return Pose(X_OH * translation(Vector3(0.0, 0.0, 0.1034)));
  });
  EXPECT_EQ(check.between(), 0);
  ASSERT_TRUE(check.suspicion);
  EXPECT_EQ(check.suspicion->between, 40);
  EXPECT_EQ(frame_text(check),
            "with the hand 103 mm farther back along its approach axis the object is between the "
            "fingers of 40 of 40 grasps, as given of 0: are the poses those of the point between "
            "the fingertips?");
}

TEST(FrameCheck, NamesOtherMistakes) {
  const ExecutedGrasps truth = grasps_of_a_box(40);
  const auto suspects = [&](const auto& change) {
    const FrameCheck check = checked_after(truth, change);
    return check.suspicion ? check.suspicion->words : std::string("nothing");
  };
  EXPECT_EQ(suspects([](const Pose& X) { return pose_from(X.linear(), 1000.0 * X.translation()); }),
            "with all positions times 0.001");
  EXPECT_EQ(suspects([](const Pose& X) { return Pose(X.inverse()); }), "with inverse poses");
  EXPECT_EQ(
      suspects([](const Pose& X) { return Pose(X * translation(Vector3(0.0, 0.0, -0.06595))); }),
      "with the hand 66 mm farther forward along its approach axis");
}

// Published grasps of a scanned object, as they are and as if they were those of the tool's point.
TEST(FrameCheck, TellsPublishedGraspsFromShiftedOnes) {
  for (const std::string object : {"mug", "power_drill"}) {
    const std::string file = "data/grasps/dexycb_franka_" + object + ".json";
    PREHEND_NEEDS_SHARED(file);
    ExecutedGrasps truth{
        {{object, compile(make_scene(
                      make_graspable(object, load_mesh(shared("data/ycb/" + object + ".obj")).mesh,
                                     Material::plastic),
                      "franka_hand"))}},
        {"-"},
        {}};
    for (const Candidate& grasp : published_grasps(shared(file), truth.objects[0].scene)) {
      truth.executions.push_back({grasp, {}});
    }
    const FrameCheck right = check_frames(truth);
    EXPECT_GE(right.between(), 80) << object;
    EXPECT_FALSE(right.suspicion) << object;
    const FrameCheck shifted = checked_after(truth, [](const Pose& X_OH) {
      return Pose(X_OH * translation(Vector3(0.0, 0.0, 0.1034)));
    });
    EXPECT_LE(shifted.between(), 10) << object;
    ASSERT_TRUE(shifted.suspicion) << object;
    EXPECT_EQ(shifted.suspicion->words,
              "with the hand 103 mm farther back along its approach axis");
  }
}

TEST(FrameCheck, FewGraspsArouseNoSuspicion) {
  const FrameCheck check = checked_after(grasps_of_a_box(3), [](const Pose& X_OH) {
    return Pose(X_OH * translation(Vector3(0.0, 0.0, 0.1034)));
  });
  EXPECT_FALSE(check.suspicion);
}

TEST(FrameCheck, IsTheSameOnAnyNumberOfThreads) {
  const ExecutedGrasps truth = grasps_of_a_box(10);
  EXPECT_EQ(frame_text(check_frames(truth, {.threads = 1})),
            frame_text(check_frames(truth, {.threads = 2})));
}

TEST(FrameCheck, CountsHandsInObstacles) {
  Scene scene = make_scene(make_graspable("box", make_box({0.04, 0.04, 0.03}), Material::plastic),
                           "franka_hand");
  // A table just below the box: level hands reach into it.
  add_obstacle(scene, "table", make_box({1.0, 1.0, 0.1}), translation(Vector3(0.0, 0.0, -0.0651)));
  ExecutedGrasps truth = grasps_of_a_box(10);
  truth.objects[0].scene = compile(std::move(scene));
  EXPECT_EQ(check_frames(truth).in_obstacles, 10);
}

TEST(OpenHand, TellsWhereTheObjectIs) {
  const ExecutedGrasps truth = grasps_of_a_box(1);
  const Candidate& grasp = truth.executions[0].grasp;
  const OpenHand hand(truth.objects[0].scene, grasp);
  const auto moved = [&](double x, double y, double z) {
    return hand.place(grasp.X_OH * translation(Vector3(x, y, z)));
  };
  const Vector3 closing = truth.objects[0].scene.scene.hand.hand->closing;
  EXPECT_EQ(moved(0.0, 0.0, 0.0), ObjectPlace::between);
  EXPECT_EQ(moved(0.0, 0.0, -0.06), ObjectPlace::beside);
  EXPECT_EQ(moved(0.0, 0.0, 0.025), ObjectPlace::palm);
  const Vector3 aside = 0.04 * closing;  // one finger's place in the middle of the box
  EXPECT_EQ(moved(aside.x(), aside.y(), aside.z()), ObjectPlace::inside);
}

TEST(FrameGuesses, AreRigidButForUnits) {
  const CompiledScene scene = box_scene({0.04, 0.04, 0.03});
  const std::vector<FrameGuess> guesses = frame_guesses(*scene.scene.hand.hand);
  EXPECT_GT(guesses.size(), 100U);
  const Pose X = Random(3).pose(0.3);
  for (const FrameGuess& guess : guesses) {
    const Pose changed = guess.corrected(X, scene);
    EXPECT_TRUE(changed.linear().isUnitary(1e-12)) << guess.words;
    EXPECT_FALSE(guess.words.empty());
    EXPECT_EQ(guess.question.back(), '?');
  }
}

}  // namespace
}  // namespace prehend::test
