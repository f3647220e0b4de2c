#include "planner/picture/visible_pixels.h"

#include <gtest/gtest.h>

#include "sim/geometry/basic_shapes.h"

namespace prehend {
namespace {

TEST(VisiblePixels, SolidBodiesHideAndTranslucentOnesDim) {
  const TriangleMesh plate = make_box({0.1, 0.1, 0.01});
  const Camera camera{.eye = {0, 0, 1}, .target = {0, 0, 0}, .up = Vector3::UnitY()};
  const DrawnBody back{plate, translation({0, 0, 0}), {0, 0, 0, 1}};
  const double alone = visible_pixels({back}, camera, 100, 80)[0];
  EXPECT_GT(alone, 100.0);
  // Its front lets 1/2 through, its back 3/4; the body before it covers it entirely.
  const DrawnBody veil{plate, translation({0, 0, 0.1}), {0, 0, 0, 0.5}};
  const std::vector<double> dimmed = visible_pixels({veil, back}, camera, 100, 80);
  EXPECT_EQ(dimmed[0], 0.0);
  EXPECT_NEAR(dimmed[1], 0.375 * alone, 0.02 * alone);
  const DrawnBody front{plate, translation({0, 0, 0.1}), {0, 0, 0, 1}};
  const std::vector<double> hidden = visible_pixels({back, front}, camera, 100, 80);
  EXPECT_EQ(hidden[0], 0.0);
  EXPECT_GT(hidden[1], alone);
}

}  // namespace
}  // namespace prehend
