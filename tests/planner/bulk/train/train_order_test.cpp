// Training: trees as xgboost itself evaluates them, the same in every run, from the right examples.
#include "planner/bulk/train/train_order.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "planner/bulk/train/data_sets.h"
#include "planner/plan/learn/grasp_features.h"
#include "planner/plan/learn/tree_model_file.h"
#include "sim/base/random.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

// A set whose grasps hold the better, the larger their first feature is; those with a negative
// second one do not hold.
GraspSet made_up_set(const std::string& hand, const std::string& object, std::uint64_t seed) {
  Random random(seed);
  GraspSet set;
  set.hand = hand;
  set.object.file = object;
  set.feature_names = grasp_feature_names();
  for (int i = 0; i < 400; ++i) {
    GraspSetEntry& grasp = set.grasps.emplace_back();
    for (std::size_t f = 0; f < kGraspFeatures.size(); ++f) {
      grasp.features.push_back(static_cast<float>(random.uniform(-1.0, 1.0)));
    }
    const bool holds = grasp.features[1] > 0.0F;
    grasp.outcome = holds ? Outcome::stable : Outcome::not_force_closure;
    if (holds) grasp.epsilon = {0.2 + 0.1 * grasp.features[0], 0.3};
  }
  return set;
}

BoostRows rows_of(const GraspSet& set) {
  BoostRows rows;
  rows.features = kGraspFeatures.size();
  for (const GraspSetEntry& grasp : set.grasps) {
    rows.values.insert(rows.values.end(), grasp.features.begin(), grasp.features.end());
    rows.labels.push_back(static_cast<float>(grasp.epsilon.lower));
  }
  return rows;
}

// Trees that are soon grown.
TrainOptions small() {
  TrainOptions options;
  options.boost.trees = 60;
  options.boost.depth = 5;
  return options;
}

constexpr const char* kNoXgboost = "built without xgboost (libxgboost-dev)";

// xgboost adds leaves in single precision; a hundred of them differ by a few of its last digits.
TEST(TrainOrder, ScoresAreWhatXgboostPredicts) {
  if (!can_boost()) GTEST_SKIP() << kNoXgboost;
  const BoostRows rows = rows_of(made_up_set("hand", "object", 4));
  const BoostOptions options;
  BoostedTrees boosted = boost_trees(rows, options);
  ASSERT_EQ(boosted.trees.size(), static_cast<std::size_t>(options.trees));
  TreeModel model;
  model.features = grasp_feature_names();
  model.base = boosted.base;
  model.trees = std::move(boosted.trees);
  check(model);
  const std::vector<float> predicted = boosted_predictions(rows, options);
  ASSERT_EQ(predicted.size(), rows.labels.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < predicted.size(); ++i) {
    const std::span<const float> row(&rows.values[i * rows.features], rows.features);
    EXPECT_NEAR(score(model, row), double{predicted[i]}, 1e-5) << i;
    largest = std::max(largest, std::abs(double{predicted[i]}));
  }
  EXPECT_GT(largest, 0.1);
}

TEST(TrainOrder, TheSameSetsGiveTheSameModel) {
  if (!can_boost()) GTEST_SKIP() << kNoXgboost;
  const std::vector<GraspSet> sets = {made_up_set("hand", "a", 1), made_up_set("hand", "b", 2)};
  EXPECT_EQ(tree_model_json(train_order(sets, small())),
            tree_model_json(train_order(sets, small())));
}

TEST(TrainOrder, LearnsWhatHoldsBest) {
  if (!can_boost()) GTEST_SKIP() << kNoXgboost;
  const TreeModel model =
      train_order({made_up_set("hand", "a", 1), made_up_set("hand", "b", 2)}, small());
  const GraspSet other = made_up_set("hand", "c", 3);
  const auto best = std::max_element(other.grasps.begin(), other.grasps.end(),
                                     [&](const GraspSetEntry& a, const GraspSetEntry& b) {
                                       return score(model, a.features) < score(model, b.features);
                                     });
  EXPECT_GT(best->features[0], 0.8F);
  EXPECT_GT(best->features[1], 0.0F);
}

// Only the order of the epsilons within a set counts.
TEST(TrainOrder, LearnsTheRankInTheSet) {
  if (!can_boost()) GTEST_SKIP() << kNoXgboost;
  const std::vector<GraspSet> sets = {made_up_set("hand", "a", 1), made_up_set("hand", "b", 2)};
  std::vector<GraspSet> others = sets;
  for (GraspSetEntry& grasp : others[1].grasps) grasp.epsilon.lower *= 10.0 * grasp.epsilon.lower;
  EXPECT_EQ(tree_model_json(train_order(sets, small())),
            tree_model_json(train_order(others, small())));
  std::swap(others[1].grasps[0].features, others[1].grasps[1].features);
  EXPECT_NE(tree_model_json(train_order(sets, small())),
            tree_model_json(train_order(others, small())));
}

TEST(TrainOrder, SaysWhatItWasTrainedOn) {
  if (!can_boost()) GTEST_SKIP() << kNoXgboost;
  GraspSet nothing_holds = made_up_set("third", "c", 3);
  for (GraspSetEntry& grasp : nothing_holds.grasps) grasp.outcome = Outcome::not_force_closure;
  GraspSet arm = made_up_set("second", "a", 2);
  arm.grasps[0].outcome = Outcome::unreachable;
  arm.grasps[1].features.clear();
  const TreeModel model = train_order({made_up_set("first", "a", 1), arm, nothing_holds}, small());
  EXPECT_EQ(model.hands, (std::vector<std::string>{"first", "second"}));
  EXPECT_EQ(model.objects, 1);
  EXPECT_EQ(model.trials, 798);
  EXPECT_FALSE(model.any_hand);
  const TreeModel many = train_order(
      {made_up_set("first", "a", 1), made_up_set("second", "a", 2), made_up_set("third", "a", 3)},
      small());
  EXPECT_TRUE(many.any_hand);
}

TEST(TrainOrder, RefusesOtherFeaturesAndNothing) {
  GraspSet set = made_up_set("hand", "a", 1);
  set.feature_names.back() = "another";
  EXPECT_EQ(test::refusal_of([&] { (void)train_order({set}); }).field(), "features");
  EXPECT_NE(std::string(test::refusal_of([] { (void)train_order({}); }).what()).find("no set"),
            std::string::npos);
}

TEST(TrainOrder, WithoutXgboostSaysWhatToInstall) {
  if (can_boost()) GTEST_SKIP() << "built with xgboost";
  EXPECT_NE(std::string(test::refusal_of([] { require_training(); }).what()).find("libxgboost-dev"),
            std::string::npos);
}

TEST(DataSets, AFolderWithoutThemIsRefused) {
  EXPECT_NE(std::string(test::refusal_of([] { (void)data_set_files({"no/such/folder"}); }).what())
                .find("no/such/folder: does not exist"),
            std::string::npos);
}

}  // namespace
}  // namespace prehend
