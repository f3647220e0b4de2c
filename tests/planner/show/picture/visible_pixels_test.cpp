#include "planner/show/picture/visible_pixels.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "planner/show/picture/draw.h"
#include "sim/base/random.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

constexpr int kWidth = 100;
constexpr int kHeight = 80;

// What is counted of bodies that are added in this order.
std::vector<double> counts_of(const std::vector<DrawnBody>& bodies, const Camera& camera) {
  VisiblePixels picture(camera, kWidth, kHeight);
  for (const DrawnBody& body : bodies) picture.add(body);
  return picture.counts();
}

const Camera kFromAbove{.eye = {0, 0, 1}, .target = {0, 0, 0}, .up = Vector3::UnitY()};

DrawnBody plate(const Vector3& at, double opacity) {
  return {make_box({0.1, 0.1, 0.01}), translation(at), {0, 0, 0, opacity}};
}

TEST(VisiblePixels, SolidBodiesHideAndTranslucentOnesDim) {
  const DrawnBody back = plate({0, 0, 0}, 1.0);
  const double alone = counts_of({back}, kFromAbove)[0];
  EXPECT_GT(alone, 100.0);
  const std::vector<double> hidden = counts_of({back, plate({0, 0, 0.1}, 1.0)}, kFromAbove);
  EXPECT_EQ(hidden[0], 0.0);
  EXPECT_GT(hidden[1], alone);
  EXPECT_EQ(counts_of({back, plate({0, 0, -0.1}, 1.0)}, kFromAbove)[0], alone);
  // Its front lets 1/2 through, its back 3/4; it covers the plate entirely. Centers on the borders
  // of its triangles are not dimmed twice.
  const std::vector<double> dimmed = counts_of({back, plate({0, 0, 0.1}, 0.5)}, kFromAbove);
  EXPECT_NEAR(dimmed[0], 0.375 * alone, 1e-5 * alone);
  EXPECT_EQ(dimmed[1], 0.0);
  EXPECT_EQ(counts_of({back, plate({0, 0, -0.1}, 0.5)}, kFromAbove)[0], alone);
}

// A veil dims what was there before it. What comes later before both is seen whole.
TEST(VisiblePixels, CountInTheOrderInWhichBodiesCome) {
  const DrawnBody veil = plate({0, 0, 0.1}, 0.5);
  const DrawnBody back = plate({0, 0, 0}, 1.0);
  const DrawnBody front = plate({0.05, 0, 0.2}, 1.0);
  EXPECT_EQ(counts_of({veil, back}, kFromAbove)[1], counts_of({back}, kFromAbove)[0]);
  const std::vector<double> counts = counts_of({back, veil, front}, kFromAbove);
  EXPECT_LT(counts[0], counts_of({back, veil}, kFromAbove)[0]);
  EXPECT_GT(counts[0], 0.0);
  EXPECT_EQ(counts[2], counts_of({front}, kFromAbove)[0]);
}

TEST(VisiblePixels, ABodySaysWhatItCoversAlsoWhereItIsHidden) {
  for (const double opacity : {1.0, 0.5}) {
    const DrawnBody back = plate({0, 0, 0}, opacity);
    VisiblePixels picture(kFromAbove, kWidth, kHeight);
    EXPECT_EQ(picture.add(plate({0.06, 0, 0.1}, 1.0)),
              counts_of({plate({0.06, 0, 0.1}, 1.0)}, kFromAbove)[0]);
    EXPECT_EQ(picture.add(back), counts_of({plate({0, 0, 0}, 1.0)}, kFromAbove)[0]);
  }
}

// Boxes of any shape, many of them thin, everywhere around the eye.
std::vector<DrawnBody> random_boxes(Random& random, int count) {
  std::vector<DrawnBody> bodies;
  for (int i = 0; i < count; ++i) {
    const Vector3 size = random.in_box(Vector3::Constant(0.01), Vector3::Constant(1.0));
    const double thin = random.uniform(0.005, 1.0);
    const Matrix3 turn = random.rotation();
    const Vector3 at = random.in_box(Vector3(-2, -2, -1), Vector3(2, 2, 2));
    // One colour for each, which is told by its red.
    bodies.push_back({make_box(Vector3(size.x(), thin * size.y(), size.z())),
                      pose_from(turn, at),
                      {(i + 1) / 255.0, 0.0, 0.0, 1.0}});
  }
  return bodies;
}

// A picture with one sample at the center of each pixel, without lights and lines, is drawn by
// other code. It may decide otherwise where an edge goes through a center.
TEST(VisiblePixels, AreThoseThatAPictureShows) {
  Random random(5);
  const DrawOptions flat{.width = kWidth,
                         .height = kHeight,
                         .samples = 1,
                         .lighting = {.sky = 1, .ground = 1, .key = 0, .fill = 0, .gloss = 0},
                         .line_width = 0.0};
  const Camera camera{.eye = {0, 0, 1.5}, .target = {0.2, 0.1, 0}, .vertical_field_of_view = 1.5};
  for (int round = 0; round < 20; ++round) {
    const std::vector<DrawnBody> bodies = random_boxes(random, 40);
    const Image image = draw(bodies, camera, flat);
    std::vector<int> shown(bodies.size(), 0);
    for (std::size_t at = 0; at < image.rgb.size(); at += 3) {
      if (image.rgb[at + 1] == 0) ++shown[image.rgb[at] - 1U];
    }
    const std::vector<double> counts = counts_of(bodies, camera);
    EXPECT_GT(std::count_if(shown.begin(), shown.end(), [](int n) { return n > 0; }), 10);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      EXPECT_NEAR(counts[i], shown[i], 1.0) << round << ", " << i;
    }
  }
}

}  // namespace
}  // namespace prehend
