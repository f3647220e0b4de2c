// What the filter calls free is looked at in small steps with the meshes; what it calls blocked
// must meet in one of them.
#include "sim/scene/reach/motion_filter.h"

#include <iostream>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "tests/sim/scene/reach/arm_among_boxes.h"

namespace prehend {
namespace {

using test::Motion;

constexpr double kFilterStep = 2e-3;  // no point moves more from one posture to the next [m]

struct Counts {
  int free = 0;
  int blocked = 0;
  int open = 0;
};

// Whether the pair, or any, is open at a part of the line.
bool is_open(const std::vector<OpenStretch>& open, double at, std::size_t pair) {
  return std::any_of(open.begin(), open.end(), [&](const OpenStretch& stretch) {
    return stretch.from <= at && at <= stretch.to &&
           std::find(stretch.pairs.begin(), stretch.pairs.end(), pair) != stretch.pairs.end();
  });
}

void expect_apart_where_settled(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                const Motion& motion, const std::vector<OpenStretch>& open) {
  const int parts = motion.parts(kFilterStep);
  for (int i = 0; i <= parts; ++i) {
    const double at = static_cast<double>(i) / parts;
    const std::vector<Pose> X_BL = motion.at(at);
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      if (is_open(open, at, p)) continue;
      ASSERT_FALSE(test::crosses(arm, pairs[p], X_BL))
          << first_name(arm, pairs[p]) << " meets " << second_name(arm, pairs[p]) << " at " << at;
    }
  }
}

bool meets_somewhere(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                     const Motion& motion) {
  const int parts = motion.parts(kFilterStep);
  for (int i = 0; i <= parts; ++i) {
    const std::vector<Pose> X_BL = motion.at(static_cast<double>(i) / parts);
    for (const ArmPair& pair : pairs) {
      if (pair_meets(arm, pair, X_BL)) return true;
    }
  }
  return false;
}

void try_motions(const CompiledArm& arm, Random& random, int motions, Counts& counts) {
  const std::vector<ArmPair> pairs = test::pairs_of(arm);
  MotionFilter filter(arm, pairs);
  std::vector<OpenStretch> open;
  for (int i = 0; i < motions; ++i) {
    SCOPED_TRACE("motion " + std::to_string(i));
    const std::vector<double> from = test::random_dofs(arm.robot(), random);
    std::vector<double> to = test::random_dofs(arm.robot(), random);
    const double length = random.uniform(0.02, 0.3);
    for (std::size_t d = 0; d < to.size(); ++d) to[d] = from[d] + length * (to[d] - from[d]);
    const Motion motion(arm, joint_values(arm.robot(), from), joint_values(arm.robot(), to));
    const JointPath path = motion.path();
    const double tightest = i % 2 == 0 ? 2e-4 : 4e-3;
    const FilterVerdict verdict = filter.line(path[0], path[1], tightest, IfClose::open, open);
    if (verdict == FilterVerdict::blocked) {
      ++counts.blocked;
      EXPECT_TRUE(meets_somewhere(arm, pairs, motion));
    } else {
      ++(verdict == FilterVerdict::free ? counts.free : counts.open);
      EXPECT_EQ(open.empty(), verdict == FilterVerdict::free);
      expect_apart_where_settled(arm, pairs, motion, open);
    }
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(MotionFilter, SaysOnlyWhatIsTrue) {
  Random random(91);
  Counts counts;
  for (int scene = 0; scene < 12; ++scene) {
    SCOPED_TRACE("scene " + std::to_string(scene));
    const CompiledScene boxes = test::among_random_boxes(random, 6);
    try_motions(*boxes.arm, random, 24, counts);
  }
  std::cout << counts.free << " motions free, " << counts.blocked << " blocked, " << counts.open
            << " open\n";
  EXPECT_GE(counts.free, 20);
  EXPECT_GE(counts.blocked, 20);
}

// A line of no length is free where the posture is, and so is one far from everything.
TEST(MotionFilter, NoMotionIsFree) {
  Random random(92);
  const CompiledScene scene = test::among_random_boxes(random, 2);
  const CompiledArm& arm = *scene.arm;
  const std::vector<ArmPair> pairs = test::pairs_of(arm);
  MotionFilter filter(arm, pairs);
  const std::vector<double> joints = joint_values(arm.robot(), arm.start);
  std::vector<OpenStretch> open;
  EXPECT_NE(filter.line(joints, joints, 2e-4, IfClose::open, open), FilterVerdict::blocked);
  const std::vector<ArmPair> none;
  EXPECT_EQ(MotionFilter(arm, none).line(joints, joints, 2e-4, IfClose::open, open),
            FilterVerdict::free);
}

// Where the arm starts away from all it is asked about, the whole line is one open stretch when
// angles are too large for single precision.
TEST(MotionFilter, LeavesLargeAnglesOpen) {
  Random random(93);
  const CompiledScene scene = test::among_random_boxes(random, 2);
  const CompiledArm& arm = *scene.arm;
  const std::vector<ArmPair> pairs = test::pairs_of(arm);
  MotionFilter filter(arm, pairs);
  std::vector<double> joints = joint_values(arm.robot(), arm.start);
  joints[0] = 1e3;
  std::vector<OpenStretch> open;
  ASSERT_EQ(filter.line(joints, joints, 2e-4, IfClose::open, open), FilterVerdict::open);
  ASSERT_EQ(open.size(), 1U);
  EXPECT_EQ(open[0].from, 0.0);
  EXPECT_EQ(open[0].to, 1.0);
  EXPECT_EQ(open[0].pairs.size(), pairs.size());
}

}  // namespace
}  // namespace prehend
