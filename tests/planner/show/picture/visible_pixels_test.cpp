#include "planner/show/picture/visible_pixels.h"

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

TEST(VisiblePixels, SolidBodiesHideAndTranslucentOnesDim) {
  const TriangleMesh plate = make_box({0.1, 0.1, 0.01});
  const Camera camera{.eye = {0, 0, 1}, .target = {0, 0, 0}, .up = Vector3::UnitY()};
  const DrawnBody back{plate, translation({0, 0, 0}), {0, 0, 0, 1}};
  const double alone = visible_pixels({back}, {}, camera, 100, 80)[0];
  EXPECT_GT(alone, 100.0);
  // Its front lets 1/2 through, its back 3/4; the body before it covers it entirely.
  const DrawnBody veil{plate, translation({0, 0, 0.1}), {0, 0, 0, 0.5}};
  const std::vector<double> dimmed = visible_pixels({veil, back}, {}, camera, 100, 80);
  EXPECT_EQ(dimmed[0], 0.0);
  EXPECT_NEAR(dimmed[1], 0.375 * alone, 0.02 * alone);
  const DrawnBody front{plate, translation({0, 0, 0.1}), {0, 0, 0, 1}};
  const std::vector<double> hidden = visible_pixels({back, front}, {}, camera, 100, 80);
  EXPECT_EQ(hidden[0], 0.0);
  EXPECT_GT(hidden[1], alone);
}

// What stands around hides and dims alike, but is not counted.
TEST(VisiblePixels, BodiesAroundHideAsThoseThatAreCounted) {
  const TriangleMesh plate = make_box({0.1, 0.1, 0.01});
  const Camera camera{.eye = {0, 0, 1}, .target = {0, 0, 0}, .up = Vector3::UnitY()};
  const DrawnBody back{plate, translation({0, 0, 0}), {0, 0, 0, 1}};
  for (const double opacity : {1.0, 0.5}) {
    const DrawnBody aside{plate, translation({0.06, 0, 0.1}), {0, 0, 0, opacity}};
    const std::vector<double> both = visible_pixels({back, aside}, {}, camera, 100, 80);
    EXPECT_EQ(visible_pixels({back}, {aside}, camera, 100, 80), std::vector<double>{both[0]});
  }
}

}  // namespace
}  // namespace prehend
