// A robot by itself: every posture in a cell, and where its tips get.
#include "planner/show/robot_picture.h"

#include <gtest/gtest.h>

#include "planner/show/palette.h"
#include "sim/robot/files/robot_file.h"

namespace prehend {
namespace {

// How many pixels of a part of the image have about this hue: that channel exceeds both others.
int tinted(const Image& image, int from_x, int to_x, std::size_t channel) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = from_x; x < to_x; ++x) {
      const auto at = static_cast<std::size_t>(3 * (y * image.width + x));
      const int value = image.rgb[at + channel];
      const int first = image.rgb[at + (channel + 1) % 3];
      const int second = image.rgb[at + (channel + 2) % 3];
      if (value > first + 60 && value > second + 60) ++count;
    }
  }
  return count;
}

TEST(RobotPicture, ShowsThePosturesAndTheWorkspace) {
  const Robot hand = find_robot("parallel_jaw");
  const PostureSurvey survey = survey_postures(hand, 200);
  const std::vector<NamedPosture> postures = telling_postures(hand);
  ASSERT_EQ(postures.size(), 1U);
  EXPECT_EQ(postures.front().name, "open");
  const Image image = robot_picture(hand, postures, survey, {.width = 600, .height = 250});
  EXPECT_EQ(image.width, 600);
  EXPECT_EQ(image.height, 250);
  // The dots of the first tip are red, and only in the second cell.
  EXPECT_EQ(tinted(image, 0, 300, 0), 0);
  EXPECT_GT(tinted(image, 300, 600, 0), 20);
}

TEST(RobotPicture, TakesFivePreshapesAtMost) {
  EXPECT_EQ(telling_postures(find_robot("dlr")).size(), 5U);
  const Robot arm = find_robot("puma560");
  ASSERT_EQ(telling_postures(arm).size(), 1U);
  EXPECT_EQ(telling_postures(arm).front().dofs, initial_dofs(arm));
}

}  // namespace
}  // namespace prehend
