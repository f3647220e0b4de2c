#include "planner/plan/grasp_text.h"

#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/scenes.h"

namespace prehend::test {
namespace {

TEST(MovedWords, SayWhatMovedAndLeaveOutWhatDidNot) {
  Trial trial;
  EXPECT_EQ(moved_text(trial), "");
  trial.overlap_shift = {0.0, 0.0, 1.2e-3};
  trial.slid = 4e-5;
  EXPECT_EQ(moved_text(trial), "the hand gave way by 1.2 mm");
  trial.pushed = {3e-3, 4e-3, 0.0};
  trial.turned = std::numbers::pi / 15.0;
  EXPECT_EQ(moved_text(trial),
            "the hand gave way by 1.2 mm; the object was pushed by 5 mm, turned by 12 degrees");
  trial.overlap_shift.setZero();
  trial.pushed.setZero();
  trial.slid = 2.5e-3;
  EXPECT_EQ(moved_text(trial), "the object was turned by 12 degrees, slid by 2.5 mm");
}

TEST(LoadWords, HaveTwoDigitsAndNoExponent) {
  EXPECT_EQ(load_factor_text({.strength = 0.1234}), "0.12");
  EXPECT_EQ(load_factor_text({.strength = 37.4}), "37");
  EXPECT_EQ(load_factor_text({.strength = 99.7}), "100");
  EXPECT_EQ(load_factor_text({.strength = 203.4}), "203");
  EXPECT_EQ(load_factor_text({.strength = 2e5}), "any");
}

TEST(BlameWords, SayWhoMetWhatAndHowDeep) {
  const CompiledScene scene = compiled(find_robot("parallel_jaw"), make_box({0.04, 0.04, 0.04}));
  Trial trial;
  EXPECT_EQ(collision_text(scene, trial), "");
  trial.outcome = Outcome::hand_blocked;
  trial.blocked = HandContact{.link = LinkId{1}};
  const std::string link = scene.links[1].name;
  const std::string by = collision_of(scene, trial).by;
  EXPECT_EQ(collision_text(scene, trial), link + " met " + by);
  trial.overlap = 3.14e-3;
  EXPECT_EQ(collision_text(scene, trial), link + " met " + by + ", 3.1 mm deep");
}

}  // namespace
}  // namespace prehend::test
