// What depth cameras know of space: free, hidden, or nothing.
#include "sim/shape/cloud/unseen_space.h"

#include <cstddef>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/index.h"
#include "tests/support/depth_camera.h"

namespace prehend {
namespace {

// All pixels show a wall at this depth [m]; 0: no reading.
DepthView wall_seen_from(const Vector3& position, float depth) {
  DepthView view{test::camera_at(position, Vector3::Zero(), {64, 48, 60.0}), {}};
  view.depth.assign(index(view.camera.width) * index(view.camera.height), depth);
  return view;
}

TEST(UnseenSpace, IsBehindWhatWasSeen) {
  const UnseenSpace space({wall_seen_from({-1.0, 0.0, 0.0}, 1.0F)});
  EXPECT_FALSE(space.contains({-0.5, 0.0, 0.0}));
  EXPECT_FALSE(space.contains({0.009, 0.1, 0.0}));  // as near as surfaces may be wrong
  EXPECT_TRUE(space.contains({0.011, 0.1, 0.0}));
  EXPECT_TRUE(space.contains({2.0, 0.0, 0.3}));
}

TEST(UnseenSpace, WhereNoCameraLooksNothingIsSaid) {
  const UnseenSpace space({wall_seen_from({-1.0, 0.0, 0.0}, 1.0F)});
  EXPECT_FALSE(space.contains({0.5, 5.0, 0.0}));   // beside the image
  EXPECT_FALSE(space.contains({-1.5, 0.0, 0.0}));  // behind the camera
  EXPECT_FALSE(space.contains({-1.0, 0.0, 0.0}));  // in it
}

TEST(UnseenSpace, PixelsWithoutReadingSayNothing) {
  const DepthView wall = wall_seen_from({-1.0, 0.0, 0.0}, 0.8F);
  for (const float none : {0.0F, std::numeric_limits<float>::infinity()}) {
    const DepthView nothing = wall_seen_from({0.0, -1.0, 0.0}, none);
    EXPECT_FALSE(UnseenSpace({nothing}).contains({0.1, 0.1, 0.0}));
    EXPECT_TRUE(UnseenSpace({wall, nothing}).contains({0.1, 0.1, 0.0}));
  }
}

TEST(UnseenSpace, OneViewThatSeesFarEnoughIsEnough) {
  const DepthView near = wall_seen_from({-1.0, 0.0, 0.0}, 0.8F);
  const DepthView far = wall_seen_from({0.0, -1.0, 0.0}, 1.3F);
  const UnseenSpace space({near, far});
  EXPECT_TRUE(UnseenSpace({near}).contains({0.1, 0.1, 0.0}));
  EXPECT_FALSE(space.contains({0.1, 0.1, 0.0}));
  EXPECT_TRUE(space.contains({0.1, 0.4, 0.0}));
  EXPECT_FALSE(UnseenSpace({}).contains({0.1, 0.4, 0.0}));
}

}  // namespace
}  // namespace prehend
