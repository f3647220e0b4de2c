#include "planner/plan/path/blend_transfer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "planner/plan/path/motion_lines.h"
#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/scene/reach/motion_check.h"
#include "tests/support/block_on_table.h"

namespace prehend {
namespace {

// Random motions with corners, and how far they are from their lines at best, for one point of the
// lines and all joints.
TEST(MotionLines, TheMotionIsWithinTheSwayOfTheLines) {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::vector<double>> points(3, std::vector<double>(3));
    for (auto& q : points) {
      for (double& value : q) value = random.uniform(-1.0, 1.0);
    }
    const JointLimits limits{{1.0, 2.0, 1.0}, {5.0, 3.0, 8.0}};
    const TimedPath path = time_blended(points, {0.8}, limits);
    const MotionLines motion = motion_lines(path, 0, path.times.size() - 1);
    EXPECT_EQ(motion.lines.front(), path.positions.front());
    for (std::size_t i = 1; i < path.times.size(); ++i) {
      const std::size_t parts = (motion.lines.size() - 1) / (path.times.size() - 1);
      const double h = path.times[i] - path.times[i - 1];
      for (int k = 0; k <= 40; ++k) {
        const double t = k / 40.0;
        double least = 10.0;  // excess over the sway, at the best place of the lines
        for (std::size_t l = (i - 1) * parts; l < i * parts; ++l) {
          for (int n = 0; n <= 20; ++n) {
            double excess = 0.0;
            for (std::size_t j = 0; j < 3; ++j) {
              const double p0 = path.positions[i - 1][j];
              const double p1 = path.positions[i][j];
              const double q =
                  p0 + t * t * (3.0 - 2.0 * t) * (p1 - p0) +
                  h * t * (1.0 - t) *
                      ((1.0 - t) * path.velocities[i - 1][j] - t * path.velocities[i][j]);
              const double line =
                  motion.lines[l][j] + n / 20.0 * (motion.lines[l + 1][j] - motion.lines[l][j]);
              // As coarsely as the lines are looked at.
              const double coarse = std::abs(motion.lines[l + 1][j] - motion.lines[l][j]) / 40.0;
              excess = std::max(excess, std::abs(q - line) - motion.sway[j] - coarse);
            }
            least = std::min(least, excess);
          }
        }
        ASSERT_LE(least, 1e-12) << round << ' ' << i << ' ' << t;
      }
    }
    for (const double sway : motion.sway) EXPECT_LE(sway, 1e-4);
  }
}

TEST(MotionLines, AStraightMotionDoesNotSway) {
  const TimedPath path =
      time_path({{0.0, 1.0}, {1.0, -1.0}}, PathKind::corners, {{1.0, 3.0}, {5.0, 5.0}});
  const MotionLines motion = motion_lines(path, 2, path.times.size() - 4);
  EXPECT_EQ(motion.lines.front(), path.positions[2]);
  for (std::size_t j = 0; j < 2; ++j) {
    EXPECT_NEAR(motion.lines.back()[j], path.positions[path.times.size() - 4][j], 1e-15);
    EXPECT_LE(motion.sway[j], 1e-15);
  }
}

class Blend : public testing::Test {
 protected:
  // Up and to the side from the start, in two lines that are free.
  static std::vector<DofValues> waypoints(const CompiledArm& arm) {
    std::vector<DofValues> points(3, arm.start);
    points[1][index(arm.dofs[0])] += 0.5;
    points[2][index(arm.dofs[0])] += 0.5;
    points[2][index(arm.dofs[1])] -= 0.3;
    return points;
  }

  static JointLimits limits(const CompiledArm& arm) {
    const std::size_t joints = arm.robot().joints.size();
    return {std::vector<double>(joints, 1.0), std::vector<double>(joints, 5.0)};
  }

  static TimedPath blended(const CompiledScene& scene, const TransferOptions& options) {
    const CompiledArm& arm = *scene.arm;
    const std::vector<double> start = joint_values(arm.robot(), arm.start);
    const auto hand = start.begin() + arm.hand_part().first_joint;
    const std::vector<double> joints(
        hand, hand + static_cast<std::ptrdiff_t>(scene.scene.hand.joints.size()));
    return blend_transfer(arm, waypoints(arm), joints, limits(arm), options, {});
  }

  static TransferOptions with_deviation(double most) {
    TransferOptions options;
    options.corner_deviation = most;
    return options;
  }

  static int stops(const TimedPath& path) {
    int stops = 0;
    for (std::size_t i = 1; i + 1 < path.times.size(); ++i) {
      bool rests = true;
      for (const double v : path.velocities[i]) rests &= v == 0.0;
      if (rests) ++stops;
    }
    return stops;
  }
};

TEST_F(Blend, RunsThroughACornerWithoutAStop) {
  const CompiledScene scene = compile(test::block_on_table());
  const TimedPath smooth = blended(scene, {});
  EXPECT_EQ(stops(smooth), 0);
  const TimedPath stopping = blended(scene, with_deviation(0.0));
  EXPECT_EQ(stops(stopping), 1);
  EXPECT_LT(smooth.times.back(), stopping.times.back() - 0.1);
  EXPECT_EQ(smooth.positions.front(), stopping.positions.front());
  EXPECT_EQ(smooth.positions.back(), stopping.positions.back());
}

// As an upper bound of the motion of all points of the arm.
TEST_F(Blend, PassesTheCornerAsCloseAsAsked) {
  const CompiledScene scene = compile(test::block_on_table());
  const CompiledArm& arm = *scene.arm;
  const std::vector<double> start = joint_values(arm.robot(), arm.start);
  for (const double most : {0.1, 0.02, 0.004}) {
    const TimedPath path = blended(scene, with_deviation(most));
    EXPECT_EQ(stops(path), 0);
    std::vector<Pose> X_corner;
    DofValues corner = waypoints(arm)[1];
    arm_link_poses(arm, joint_values(arm.robot(), corner), X_corner);
    double least = 10.0;
    for (const std::vector<double>& q : path.positions) {
      std::vector<Pose> X;
      arm_link_poses(arm, q, X);
      double farthest = 0.0;
      for (std::size_t l = 0; l < X.size(); ++l) {
        farthest = std::max(farthest, (X[l].translation() - X_corner[l].translation()).norm());
      }
      least = std::min(least, farthest);
    }
    // Samples are some millimetres apart.
    EXPECT_LE(least, most + 2e-3) << most;
  }
}

TEST_F(Blend, IsFreeByTheSameProof) {
  const CompiledScene scene = compile(test::block_on_table());
  const CompiledArm& arm = *scene.arm;
  const TimedPath path = blended(scene, {});
  const MotionLines motion = motion_lines(path, 0, path.times.size() - 1);
  std::vector<ArmPair> pairs = arm.arm_pairs;
  pairs.insert(pairs.end(), arm.hand_pairs.begin(), arm.hand_pairs.end());
  EXPECT_FALSE(first_blocked(arm, pairs, motion.lines, motion.sway, MotionCheckOptions{}));
  // With as much sway as the arm is long, everything is in the way.
  EXPECT_TRUE(first_blocked(arm, pairs, motion.lines, std::vector<double>(motion.sway.size(), 1.0),
                            MotionCheckOptions{}));
}

}  // namespace
}  // namespace prehend
