// A robot by itself: every posture in a cell, and where its tips get.
#include "planner/show/robot_picture.h"

#include <algorithm>
#include <cmath>

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
  ASSERT_EQ(postures.size(), 4U);
  EXPECT_EQ(postures.front().name, "open");
  const Image image =
      robot_picture(hand, {postures[1], postures[2]}, survey, {.width = 900, .height = 250});
  EXPECT_EQ(image.width, 900);
  EXPECT_EQ(image.height, 250);
  // The dots of the first tip are red, and only in the last cell.
  EXPECT_EQ(tinted(image, 300, 600, 0), 0);
  EXPECT_GT(tinted(image, 600, 900, 0), 20);
  // The approach is drawn in the first cell only.
  EXPECT_GT(tinted(image, 0, 300, 2), 20);
  EXPECT_EQ(tinted(image, 300, 600, 2), 0);
}

// Closed, the jaws touch each other; on a cylinder of half their width they stand as far apart.
TEST(RobotPicture, ShowsTheHandHalfClosedClosedAndOnACylinder) {
  const Robot hand = find_robot("parallel_jaw");
  const double width = hand.hand->preshapes.front().max_width;
  const std::vector<NamedPosture> postures = telling_postures(hand);
  ASSERT_EQ(postures.size(), 4U);
  const auto apart = [&](const NamedPosture& posture) {
    std::vector<Pose> X_HL;
    link_poses(hand, posture.joints, X_HL);
    std::vector<double> sides;
    for (std::size_t l = 1; l < hand.links.size(); ++l) {
      const Vector3 middle = X_HL[l] * bounds(hand.links[l].mesh).center();
      sides.push_back(hand.hand->closing.dot(middle));
    }
    return *std::max_element(sides.begin(), sides.end()) -
           *std::min_element(sides.begin(), sides.end());
  };
  const double closed = apart(postures[2]);
  EXPECT_NEAR(apart(postures[0]) - closed, width, 1e-3);
  EXPECT_NEAR(apart(postures[1]) - closed, 0.5 * width, 1e-3);
  EXPECT_NEAR(apart(postures[3]) - closed, 0.5 * width, 1e-3);
  ASSERT_TRUE(postures[3].grasped);
  EXPECT_NEAR(bounds(postures[3].grasped->mesh).diagonal(), 0.5 * width * std::sqrt(6.0), 1e-6);
}

TEST(RobotPicture, TakesThreePreshapesAtMost) {
  EXPECT_EQ(telling_postures(find_robot("dlr")).size(), 6U);
  const Robot arm = find_robot("puma560");
  ASSERT_EQ(telling_postures(arm).size(), 1U);
  EXPECT_EQ(telling_postures(arm).front().joints, joint_values(arm, initial_dofs(arm)));
}

}  // namespace
}  // namespace prehend
