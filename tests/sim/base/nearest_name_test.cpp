#include "sim/base/nearest_name.h"

#include <gtest/gtest.h>

namespace prehend {
namespace {

TEST(NearestName, CountsWhatHasToBeChanged) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("plan", "plan"), 0);
  EXPECT_EQ(edit_distance("", "plan"), 4);
  EXPECT_EQ(edit_distance("paln", "plan"), 1);
  EXPECT_EQ(edit_distance("pln", "plan"), 1);
  EXPECT_EQ(edit_distance("plane", "plan"), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 3);
}

TEST(NearestName, IsTheOneWithTheLeastChanges) {
  const std::vector<std::string> hands = {"barrett", "franka_hand", "parallel_jaw",
                                          "parallel_jaw_wide"};
  EXPECT_EQ(nearest_name("barett", hands), "barrett");
  EXPECT_EQ(nearest_name("franka-hand", hands), "franka_hand");
  EXPECT_EQ(nearest_name("parallel_jaws", hands), "parallel_jaw");
  EXPECT_EQ(did_you_mean("barett", hands), "did you mean barrett? ");
}

TEST(NearestName, IsNoneWhereNothingIsClose) {
  EXPECT_EQ(nearest_name("grasp", {"plan", "render", "serve"}), "");
  EXPECT_EQ(nearest_name("", {"plan"}), "");
  EXPECT_EQ(nearest_name("ab", {"xy"}), "");
  EXPECT_EQ(nearest_name(std::string(1000, 'a'), {std::string(1000, 'a')}), "");
  EXPECT_EQ(did_you_mean("grasp", {"plan"}), "");
}

}  // namespace
}  // namespace prehend
