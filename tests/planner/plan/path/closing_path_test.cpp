// The motion of a hand that closes, from where its joints end.
#include "planner/plan/path/closing_path.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "sim/base/random.h"

namespace prehend {
namespace {

// A hand of so many fingers, each on a drive of its own that closes at 1 rad/s.
Robot hand_of(int fingers) {
  Robot hand;
  for (int f = 0; f < fingers; ++f) {
    Joint joint{.name = "joint"};
    joint.lower = 0.0;
    joint.upper = 2.0;
    joint.dof = f;
    hand.joints.push_back(joint);
    hand.dofs.push_back({.name = "dof", .lower = 0.0, .upper = 2.0, .closing_velocity = 1.0});
  }
  return hand;
}

TEST(ClosingPath, HasAPostureWhereEachJointArrives) {
  const ClosingPath path = closing_path(hand_of(3), {0.0, 0.0, 0.0}, {0.5, 1.5, 1.0});
  ASSERT_EQ(path.times, (std::vector<double>{0.0, 0.5, 1.0, 1.5}));
  EXPECT_EQ(path.postures[1], (std::vector<double>{0.5, 0.5, 0.5}));
  EXPECT_EQ(path.postures[2], (std::vector<double>{0.5, 1.0, 1.0}));
  EXPECT_EQ(path.postures[3], (std::vector<double>{0.5, 1.5, 1.0}));
}

// Two fingers that arrive 62 ns apart, as those of a Barrett hand on a can, arrive together.
TEST(ClosingPath, JointsThatArriveNearlyTogetherDoSo) {
  const ClosingPath path = closing_path(hand_of(3), {0.0, 0.0, 0.0}, {0.5, 0.5 + 6.2e-8, 1.0});
  ASSERT_EQ(path.times.size(), 3U);
  EXPECT_EQ(path.postures[1][0], 0.5);
  EXPECT_EQ(path.postures[1][1], 0.5 + 6.2e-8);
}

TEST(ClosingPath, NoTwoPosturesAreWithinAMillisecond) {
  std::uint64_t seed = 5;
  for (int n = 0; n < 300; ++n) {
    Random random(seed + static_cast<std::uint64_t>(n));
    std::vector<double> to;
    for (int f = 0; f < 6; ++f) {
      // Many near each other, and near the start.
      const double coarse = 0.25 * std::floor(4.0 * random.uniform(0.0, 1.0));
      to.push_back(coarse + std::pow(10.0, random.uniform(-9.0, -2.0)));
    }
    const ClosingPath path = closing_path(hand_of(6), std::vector<double>(6, 0.0), to);
    EXPECT_EQ(path.postures.back(), to);
    for (std::size_t i = 1; i < path.times.size(); ++i) {
      const bool only = path.times.size() == 2;
      EXPECT_TRUE(only || path.times[i] - path.times[i - 1] >= 1e-3) << n;
      for (std::size_t j = 0; j < to.size(); ++j) {
        EXPECT_LE(path.postures[i - 1][j], path.postures[i][j]);
        // Never farther than the drive, never a millisecond behind it.
        const double drive = std::min(path.times[i], to[j]);
        EXPECT_NEAR(path.postures[i][j], drive, 1e-12);
      }
    }
  }
}

// A linkage: the tip keeps its direction until the first link stops, then turns in.
TEST(ClosingPath, ATipTurnsWhereItsLinkageDoes) {
  Robot hand = hand_of(1);
  hand.dofs[0].coupling = Coupling::by_finger;
  Joint tip = hand.joints[0];
  tip.lower = -2.0;
  tip.parent = 0;
  tip.ratio = -1.0;
  tip.across = 0;
  tip.ahead = 3.0;
  hand.joints.push_back(tip);
  const ClosingPath path = closing_path(hand, {0.0, 0.0}, {0.5, 0.3});
  // At -1 rad/s to -0.5, and back at 2 rad/s.
  ASSERT_EQ(path.times.size(), 3U);
  EXPECT_DOUBLE_EQ(path.postures[1][1], -0.5);
  EXPECT_DOUBLE_EQ(path.times[2], 0.9);
  EXPECT_EQ(path.postures[2], (std::vector<double>{0.5, 0.3}));
}

TEST(ClosingPath, AHandThatIsClosedHasOnePosture) {
  EXPECT_EQ(closing_path(hand_of(2), {0.3, 0.4}, {0.3, 0.4}).postures.size(), 1U);
  EXPECT_EQ(closing_path(hand_of(1), {0.3}, {0.3 + 1e-9}).postures.size(), 2U);
}

}  // namespace
}  // namespace prehend
