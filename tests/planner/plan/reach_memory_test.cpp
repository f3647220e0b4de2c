// Guesses about the reach of an arm, from the poses that it was asked for.
#include "planner/plan/reach_memory.h"

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

Pose hand_turned_by(double angle) {
  Pose pose = translation({0.1 * angle, 0.2, 0.3});
  pose.linear() = Eigen::AngleAxisd(angle, Vector3::UnitY()).toRotationMatrix();
  return pose;
}

TEST(ReachMemory, KnowsNothingBeforeItWasTold) {
  ReachMemory memory;
  EXPECT_FALSE(memory.seems_out_of_reach(hand_turned_by(0.0)));
  for (int i = 0; i < 3; ++i) memory.add(hand_turned_by(0.1 * i), false);
  EXPECT_FALSE(memory.seems_out_of_reach(hand_turned_by(0.0)));
}

TEST(ReachMemory, GuessesFromTheNearestOrientations) {
  ReachMemory memory;
  for (int i = 0; i < 6; ++i) memory.add(hand_turned_by(0.1 * i), false);
  for (int i = 0; i < 6; ++i) memory.add(hand_turned_by(2.0 + 0.1 * i), true);
  EXPECT_TRUE(memory.seems_out_of_reach(hand_turned_by(0.25)));
  EXPECT_FALSE(memory.seems_out_of_reach(hand_turned_by(2.25)));
  // Far from all that it knows, it does not guess.
  EXPECT_FALSE(memory.seems_out_of_reach(hand_turned_by(-1.5)));
  // One that was reached in between is enough.
  memory.add(hand_turned_by(0.25), true);
  EXPECT_FALSE(memory.seems_out_of_reach(hand_turned_by(0.25)));
}

// The four nearest by sorting all of them.
TEST(ReachMemory, AgreesWithSorting) {
  Random random(161);
  ReachMemory memory;
  std::vector<std::pair<Eigen::Quaterniond, bool>> all;
  int out_of_reach = 0;
  for (int i = 0; i < 400; ++i) {
    const Pose pose = random.pose(0.1);
    const Eigen::Quaterniond q = quaternion_of(pose);
    auto sorted = all;
    std::sort(sorted.begin(), sorted.end(), [&](const auto& a, const auto& b) {
      return q.angularDistance(a.first) < q.angularDistance(b.first);
    });
    bool expected = sorted.size() >= 4;
    for (std::size_t k = 0; k < std::min<std::size_t>(4, sorted.size()); ++k) {
      expected = expected && q.angularDistance(sorted[k].first) <= 0.6 && !sorted[k].second;
    }
    EXPECT_EQ(memory.seems_out_of_reach(pose), expected) << i;
    out_of_reach += expected;
    const bool reached = random.uniform(0.0, 1.0) < 0.2;
    memory.add(pose, reached);
    all.emplace_back(q, reached);
  }
  EXPECT_GT(out_of_reach, 10);
}

}  // namespace
}  // namespace prehend
