#include "sim/scene/reach/cartesian_line.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "tests/support/library_scenes.h"

namespace prehend {
namespace {

class Line : public testing::Test {
 protected:
  static const CompiledScene& scene() {
    static const CompiledScene kScene = test::compiled_library_scene("mug_on_table");
    return kScene;
  }
  static const CompiledArm& arm() { return *scene().arm; }

  static Pose hand_at(const DofValues& dofs) {
    std::vector<Pose> X_BJ;
    joint_poses(arm().robot(), joint_values(arm().robot(), dofs), X_BJ);
    return arm().X_BO.inverse() * X_BJ[index(arm().hand_part().joint)] * arm().hand_part().X_JR;
  }
};

// Equal parts of the way and of the angle at each step.
TEST_F(Line, MovesStraightAndTurnsEvenly) {
  const Pose from = hand_at(arm().start);
  const Eigen::AngleAxisd turn(0.3, Vector3(1.0, -2.0, 0.5).normalized());
  Pose to = from;
  to.linear() = from.linear() * turn.toRotationMatrix();
  to.translation() += Vector3(0.02, -0.03, 0.04);
  const FollowedLine line = follow_line(arm(), from, to, arm().start, {});
  ASSERT_EQ(line.end, LineEnd::followed);
  EXPECT_EQ(line.failed, -1);
  ASSERT_GT(line.postures.size(), 10U);
  for (std::size_t i = 0; i < line.postures.size(); ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(line.postures.size() - 1);
    const Pose X_OH = hand_at(line.postures[i]);
    EXPECT_LT(
        (X_OH.translation() - from.translation() - part * (to.translation() - from.translation()))
            .norm(),
        1e-7);
    const Matrix3 expected =
        from.linear() * Eigen::AngleAxisd(0.3 * part, turn.axis()).toRotationMatrix();
    EXPECT_TRUE(X_OH.linear().isApprox(expected, 1e-7)) << i;
  }
}

TEST_F(Line, ATurnOnTheSpotHasStepsOfItsOwn) {
  const Pose from = hand_at(arm().start);
  const Pose to = from * Pose(Eigen::AngleAxisd(0.399, Vector3::UnitZ()));
  const FollowedLine line = follow_line(arm(), from, to, arm().start, {});
  ASSERT_EQ(line.end, LineEnd::followed);
  EXPECT_EQ(line.postures.size(), 21U);  // 0.399 rad at 0.1 m in steps of 2 mm
}

TEST_F(Line, NamesTheStepThatIsOutOfReach) {
  const Pose from = hand_at(arm().start);
  const Pose to = translation(Vector3(0.0, 0.0, 3.0)) * from;
  const FollowedLine line = follow_line(arm(), from, to, arm().start, {});
  EXPECT_NE(line.end, LineEnd::followed);
  EXPECT_EQ(index(line.failed), line.postures.size());
  EXPECT_LT(line.failed, 1500);
}

TEST_F(Line, RefusesAJump) {
  const Pose from = hand_at(arm().start);
  const Pose to = translation(Vector3(0.05, 0.0, 0.0)) * from;
  ReachOptions options;
  options.largest_joint_step = 1e-5;
  const FollowedLine line = follow_line(arm(), from, to, arm().start, options);
  EXPECT_EQ(line.end, LineEnd::jump);
  EXPECT_EQ(line.failed, 1);
  EXPECT_EQ(line.postures, (std::vector<DofValues>{arm().start}));
}

}  // namespace
}  // namespace prehend
