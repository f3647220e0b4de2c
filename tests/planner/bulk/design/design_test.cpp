// Hands with a measure changed, and what they grasp.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "planner/bulk/design/design_series.h"
#include "planner/plan/accuracy.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/derive_hand.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

Robot hand_at(const std::string& name, const std::string& words, double value) {
  return with_measure(with_hand(find_robot(name)), hand_variation(words), value);
}

bool is_in(const std::string& words, const InputError& error) {
  return std::string(error.what()).find(words) != std::string::npos;
}

// The middle of the last link of each finger in the base frame, at the initial joints.
std::vector<Vector3> link_middles(const Robot& hand) {
  std::vector<Pose> X_BL;
  link_poses(hand, joint_values(hand, initial_dofs(hand)), X_BL);
  std::vector<Vector3> middles;
  for (std::size_t l = 0; l < hand.links.size(); ++l) {
    middles.push_back(X_BL[l] * bounds(hand.links[l].mesh).center());
  }
  return middles;
}

double widest(const Robot& hand) {
  double most = 0.0;
  for (const Preshape& preshape : hand.hand->preshapes) most = std::max(most, preshape.max_width);
  return most;
}

TEST(HandVariation, ReadsItsWords) {
  const HandVariation variation = hand_variation("finger.length=0.8:1.2");
  EXPECT_EQ(variation.part, "finger");
  EXPECT_EQ(variation.measure, HandMeasure::length);
  EXPECT_EQ(variation.count, 5);
  EXPECT_DOUBLE_EQ(variation.value(0), 0.8);
  EXPECT_DOUBLE_EQ(variation.value(2), 1.0);
  EXPECT_DOUBLE_EQ(variation.value(4), 1.2);
  EXPECT_EQ(hand_variation("a.b.upper=-1:1:3").part, "a.b");
}

TEST(HandVariation, RefusesOtherWords) {
  for (const char* words :
       {"", "finger", "finger.length", ".length=1:2", "finger.length=1", "finger.length=1:2:3:4",
        "finger.length=a:2", "finger.length=1:2:1", "finger.length=1:2:1000", "finger.length=0:1",
        "finger.length=1:nan", "finger.weight=1:2", "finger.size=1:2", "finger.friction=0:1"}) {
    EXPECT_TRUE(is_in("--vary", test::refusal_of([&] { hand_variation(words); }))) << words;
  }
}

TEST(WithMeasure, ALongerFingerIsStretchedAndCarriesItsEndAlong) {
  const Robot plain = with_hand(find_robot("barrett"));
  const Robot longer = hand_at("barrett", "finger.length=0.5:2", 1.5);
  ASSERT_EQ(longer.links.size(), plain.links.size());
  const std::vector<Vector3> before = link_middles(plain);
  const std::vector<Vector3> after = link_middles(longer);
  double moved = 0.0;
  for (std::size_t l = 0; l < before.size(); ++l) {
    const double before_size = bounds(plain.links[l].mesh).size().norm();
    const double after_size = bounds(longer.links[l].mesh).size().norm();
    if (plain.links[l].joint < 0) {
      EXPECT_EQ(after_size, before_size);
    }
    EXPECT_LE(after_size, 1.5 * before_size + 1e-12);
    moved = std::max(moved, (after[l] - before[l]).norm());
  }
  EXPECT_GT(moved, 0.02);
  EXPECT_GT(widest(longer), widest(hand_at("barrett", "finger.length=0.5:2", 1.0)));
}

TEST(WithMeasure, AFactorOfOneChangesNoShape) {
  const Robot plain = find_robot("barrett");
  for (const char* words : {"finger.length=1:2", "hand.size=1:2"}) {
    const Robot same = hand_at("barrett", words, 1.0);
    for (std::size_t l = 0; l < plain.links.size(); ++l) {
      for (std::size_t v = 0; v < plain.links[l].mesh.vertices.size(); ++v) {
        EXPECT_LT((same.links[l].mesh.vertices[v] - plain.links[l].mesh.vertices[v]).norm(), 1e-12);
      }
    }
  }
}

TEST(WithMeasure, AHandOfTwiceTheSizeOpensTwiceAsWide) {
  for (const char* name : {"barrett", "parallel_jaw"}) {
    const Robot one = hand_at(name, "hand.size=1:2", 1.0);
    const Robot two = hand_at(name, "hand.size=1:2", 2.0);
    EXPECT_NEAR(widest(two) / widest(one), 2.0, 0.05) << name;
    const std::vector<Vector3> small = link_middles(one);
    const std::vector<Vector3> large = link_middles(two);
    for (std::size_t l = 0; l < small.size(); ++l) {
      EXPECT_LT((large[l] - 2.0 * small[l]).norm(), 1e-9) << name;
    }
  }
}

TEST(WithMeasure, LimitsAreThoseOfTheDegreeOfFreedom) {
  const Robot plain = with_hand(find_robot("barrett"));
  const std::string name = plain.dofs.back().name;
  const Robot less = hand_at("barrett", name + ".upper=1:2", 1.2);
  EXPECT_EQ(less.dofs.back().upper, 1.2);
  EXPECT_EQ(less.dofs.back().lower, plain.dofs.back().lower);
  EXPECT_TRUE(is_in("exclude each other",
                    test::refusal_of([&] { hand_at("barrett", name + ".upper=-2:-1", -1.0); })));
}

TEST(WithMeasure, RefusalsListWhatThereIs) {
  EXPECT_TRUE(
      is_in("finger", test::refusal_of([&] { hand_at("barrett", "thumb.length=1:2", 1.0); })));
  EXPECT_TRUE(is_in(find_robot("barrett").dofs.front().name,
                    test::refusal_of([&] { hand_at("barrett", "wrist.upper=1:2", 1.0); })));
  EXPECT_TRUE(
      is_in("cups", test::refusal_of([&] { hand_at("suction_cup_30", "hand.size=1:2", 1.0); })));
}

PlanOptions few_trials_of_designs() {
  PlanOptions options = plan_options(Accuracy::draft);
  options.search.trials = 60;
  return options;
}

std::vector<Scene> box_and_ball() {
  const Robot jaw = with_hand(find_robot("parallel_jaw"));
  Scene box = test::scene_with(jaw, make_box({0.03, 0.05, 0.1}));
  box.object.name = "box";
  Scene large = test::scene_with(jaw, make_box({0.1, 0.12, 0.15}));
  large.object.name = "large";
  return {box, large};
}

TEST(DesignSeries, ALargerHandTakesALargerObject) {
  const HandVariation variation = hand_variation("hand.size=1:2.4:2");
  const std::vector<DesignPoint> points =
      design_series(box_and_ball(), variation, few_trials_of_designs());
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[0].object, "box");
  EXPECT_GT(points[0].epsilon, 0.0);
  EXPECT_EQ(points[1].epsilon, 0.0);
  EXPECT_GT(points[3].epsilon, 0.0);
  EXPECT_GT(points[3].opening, points[1].opening);
  const std::string csv = design_csv(points, variation);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5);
  const std::string page = design_page(points, variation, "jaw");
  EXPECT_NE(page.find("<svg"), std::string::npos);
  EXPECT_NE(page.find("large"), std::string::npos);
}

TEST(DesignSeries, MoreFrictionNeverHoldsLess) {
  const std::vector<DesignPoint> points = design_series(
      box_and_ball(), hand_variation("hand.friction=0.1:1:3"), few_trials_of_designs());
  EXPECT_LE(points[0].epsilon, points[2].epsilon);
  EXPECT_LE(points[2].epsilon, points[4].epsilon);
  EXPECT_GT(points[4].epsilon, 0.0);
}

TEST(DesignSeries, TheSameOnAnyNumberOfThreads) {
  const HandVariation variation = hand_variation("hand.size=1:1.4:2");
  const auto csv = [&](int threads) {
    return design_csv(
        design_series(box_and_ball(), variation, few_trials_of_designs(), {.threads = threads}),
        variation);
  };
  EXPECT_EQ(csv(1), csv(2));
}

}  // namespace
}  // namespace prehend
