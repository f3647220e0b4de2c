// The tracker's bounds against brute force along motions.
#include "sim/trial/gap_tracker.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "sim/base/random.h"
#include "sim/shape/object_generator.h"
#include "tests/support/brute_force.h"

namespace prehend {
namespace {

constexpr double kRounding = 1e-12;  // coordinates below a metre

struct Bodies {
  std::string name;
  TriangleMesh a;
  TriangleMesh b;
};

std::vector<Bodies> bodies() {
  TriangleMesh fork = make_box({0.01, 0.01, 0.06});
  append(fork, transformed(make_box({0.01, 0.01, 0.06}), translation({0.03, 0.0, 0.0})));
  return {{"mug and box", generate_object("mug", 300), make_box({0.02, 0.03, 0.08}, 2)},
          {"ball and ball", make_sphere(0.03, 1), make_sphere(0.02, 1)},
          {"fork and plate", fork, make_box({0.1, 0.08, 0.002}, 2)}};
}

// Turns and shifts b's pose by less than `most` for any of its points within `radius` of its frame.
Pose nudged(Random& random, const Pose& X, double radius, double most) {
  const Vector3 shift = random.vector(0.0, 0.6 * most);
  const double angle = random.uniform(-0.4, 0.4) * most / radius;
  const Matrix3 turn = Eigen::AngleAxisd(angle, random.direction()).toRotationMatrix();
  return pose_from(turn * X.linear(), X.translation() + shift);
}

TEST(GapTracker, BracketsTheGapAlongAnyMotion) {
  Random random(91);
  for (const Bodies& pair : bodies()) {
    const ProximityMesh a(pair.a);
    const ProximityMesh b(pair.b);
    const auto soup_a = test::soup(pair.a);
    const double radius = max_distance(pair.b, Vector3::Zero());
    for (int run = 0; run < 8; ++run) {
      // In every second run nearly all lists of near pairs are too long to be kept.
      GapTracker tracker(a, b, run % 2 == 0 ? 400 : 3);
      const Matrix3 turn = random.rotation();
      Pose X_AB = pose_from(turn, 0.15 * random.direction());
      double moved = 0.0;
      for (int step = 0; step < 40; ++step) {
        SCOPED_TRACE(pair.name + " run " + std::to_string(run) + " step " + std::to_string(step));
        const double left = step % 7 == 0 ? random.uniform(1e-4, 0.05) : 1.0;
        const Gap gap = tracker.query(X_AB, moved, left);
        const double expected = test::surface_gap(soup_a, test::soup(pair.b, X_AB));
        ASSERT_LE(gap.lower, expected + kRounding);
        ASSERT_GE(gap.upper, expected - kRounding);
        // Where a motion could still bring contact, the bound must allow a step.
        if (expected > 0.0) {
          ASSERT_GT(gap.lower, 0.0);
        }
        // From big jumps through each other to the small steps of bodies that nearly touch.
        const double most = step % 5 == 0 ? random.uniform(0.0, 0.03) : 0.7 * gap.lower + 1e-6;
        const Pose next = nudged(random, X_AB, radius, std::min(most, 0.05));
        moved = std::min(most, 0.05);
        X_AB = next;
      }
      EXPECT_EQ(tracker.queries(), 40);
    }
  }
}

TEST(GapTracker, IsExactCloseBy) {
  const ProximityMesh box(make_box({0.05, 0.05, 0.05}, 3));
  for (const int most_pairs : {400, 3}) {
    GapTracker tracker(box, box, most_pairs);
    double height = 0.06;
    for (int i = 0; i < 200 && height > 0.05 + 4e-5; ++i) {
      const Gap gap = tracker.query(translation({0.0, 0.0, height}), i == 0 ? 0.0 : 1e-4, 1.0);
      if (height < 0.0503) {
        EXPECT_NEAR(gap.upper, height - 0.05, kRounding);
      }
      height -= 1e-4;
    }
  }
}

TEST(SafeStep, LeavesTheContactGap) {
  const TrialOptions options;
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(safe_step({1e-3, inf, {}}, options), 1e-3 - options.contact_gap);
  // A bound below the gap where motions end still lets bodies approach, by a part of it.
  EXPECT_DOUBLE_EQ(safe_step({4e-5, 1e-3, {}}, options), 1e-5);
}

}  // namespace
}  // namespace prehend
