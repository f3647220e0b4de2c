#include "planner/show/motion_frames.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/held_cube.h"

namespace prehend {
namespace {

using test::from_above;
using test::held_cube;
using test::HeldCube;
using test::motion_of;

TEST(NamedFrames, AreAsManyAsAskedAndShowEverySegment) {
  const HeldCube held = held_cube();
  const GraspMotion motion = motion_of(held);
  const double end = motion.frames.back().time;
  EXPECT_TRUE(named_frames(motion, 0).empty());
  for (const int count : {1, 2, 3, 4, 8, 50}) {
    const std::vector<NamedFrame> frames = named_frames(motion, count);
    ASSERT_EQ(static_cast<int>(frames.size()), count);
    EXPECT_EQ(frames.back().frame.time, end);
    EXPECT_EQ(frames.back().segment, "close");
    for (std::size_t i = 1; i < frames.size(); ++i) {
      EXPECT_LT(frames[i - 1].frame.time, frames[i].frame.time);
    }
    if (count < 2) continue;
    EXPECT_EQ(frames.front().frame.time, 0.0);
    EXPECT_EQ(frames.front().segment, "approach");
    if (count < 3) continue;
    EXPECT_EQ(std::count_if(frames.begin(), frames.end(),
                            [](const NamedFrame& f) { return f.segment == "approach > close"; }),
              1);
  }
}

TEST(NamedFrames, LieOnTheMotion) {
  const HeldCube held = held_cube();
  for (const NamedFrame& named : named_frames(motion_of(held), 9)) {
    if (named.segment != "approach") continue;
    const Vector3 moved = held.trial.X_OH.translation() - named.frame.X_OH.translation();
    const double way = held.trial.travel - 0.1 * named.frame.time;  // at the approach's 0.1 m/s
    EXPECT_LT((moved - Vector3(0, 0, -way)).norm(), 1e-9);
    EXPECT_LT((named.frame.X_OH.linear() - held.trial.X_OH.linear()).norm(), 1e-9);
  }
}

TEST(NamedFrames, NoneWhereNothingMoves) {
  HeldCube held = held_cube();
  Candidate closed = from_above();
  closed.preshape.reset();
  closed.joints = held.trial.joints;
  held.trial.travel = 0.0;
  EXPECT_TRUE(named_frames(grasp_motion(held.scene, closed, held.trial, nullptr), 8).empty());
}

}  // namespace
}  // namespace prehend
