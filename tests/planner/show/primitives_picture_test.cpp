// An object and its primitives in one picture.
#include "planner/show/primitives_picture.h"

#include <gtest/gtest.h>

#include "primitives/decompose.h"
#include "sim/shape/basic_shapes.h"

namespace prehend {
namespace {

// Of each kind one beside the object: the first solid is red, the second blue.
TEST(PrimitivesPicture, ShowsEachSolidInItsColour) {
  Decomposition parts;
  parts.primitives = {{Cone{0.02, 0.05, 0.1}, translation({0.1, 0.0, 0.0})},
                      {Box{Vector3::Constant(0.06)}, translation({-0.1, 0.0, 0.0})}};
  parts.share = {0.5, 0.5};
  parts.distances_of.resize(2);
  const Image image = primitives_picture(make_sphere(0.05), parts, {.width = 400, .height = 200});
  EXPECT_EQ(image.width, 400);
  EXPECT_EQ(image.height, 200);
  int red = 0;
  int blue = 0;
  // Below the text.
  for (std::size_t at = 3 * 400 * 80; at < image.rgb.size(); at += 3) {
    red += image.rgb[at] > image.rgb[at + 2] + 60 ? 1 : 0;
    blue += image.rgb[at + 2] > image.rgb[at] + 60 ? 1 : 0;
  }
  EXPECT_GT(red, 200);
  EXPECT_GT(blue, 200);
}

}  // namespace
}  // namespace prehend
