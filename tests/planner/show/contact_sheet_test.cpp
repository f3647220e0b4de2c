#include "planner/show/contact_sheet.h"

#include <gtest/gtest.h>

#include "tests/support/held_cube.h"

namespace prehend {
namespace {

using test::held_cube;
using test::HeldCube;

int dark_pixels(const Image& image) {
  int count = 0;
  for (std::size_t at = 0; at < image.rgb.size(); at += 3) count += image.rgb[at] < 200 ? 1 : 0;
  return count;
}

TEST(ContactSheet, HasACellForEachAndTheSameBytesTwice) {
  const HeldCube held = held_cube();
  const PictureSize size{150, 100};
  const Image one = contact_sheet(held.scene, {held.grasp}, 2, size);
  const Image three = contact_sheet(held.scene, {held.grasp, held.grasp, held.grasp}, 2, size);
  EXPECT_GE(one.width, 150);
  EXPECT_GT(one.height, 100);
  EXPECT_EQ(three.width, 2 * one.width);
  EXPECT_EQ(three.height, 2 * one.height);
  EXPECT_GT(dark_pixels(one), 1000);
  EXPECT_EQ(dark_pixels(three), 3 * dark_pixels(one));
  EXPECT_EQ(contact_sheet(held.scene, {held.grasp}, 2, size).rgb, one.rgb);
}

}  // namespace
}  // namespace prehend
