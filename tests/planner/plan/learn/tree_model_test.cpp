// What a model says of a candidate, by closed forms, and which models are refused.
#include "planner/plan/learn/tree_model.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "planner/plan/learn/grasp_features.h"
#include "planner/plan/learn/tree_model_file.h"
#include "sim/base/input_error.h"
#include "tests/support/refusal_of.h"

namespace prehend {
namespace {

Tree one_split(int feature, float threshold, float below, float above) {
  return {{feature, threshold, 1, 2, 0.0F}, {-1, 0.0F, -1, -1, below}, {-1, 0.0F, -1, -1, above}};
}

TreeModel two_trees() {
  TreeModel model;
  model.features_version = 1;
  model.features = {"a", "b"};
  model.hands = {"some_hand"};
  model.objects = 2;
  model.trials = 30;
  model.base = 0.25;
  model.trees = {one_split(0, 1.5F, 10.0F, 20.0F),
                 {{1, 0.0F, 1, 2, 0.0F},
                  {-1, 0.0F, -1, -1, 0.5F},
                  {0, 4.0F, 3, 4, 0.0F},
                  {-1, 0.0F, -1, -1, 1.0F},
                  {-1, 0.0F, -1, -1, 2.0F}}};
  return model;
}

double score_of(const TreeModel& model, float a, float b) {
  const std::array<float, 2> features = {a, b};
  return score(model, features);
}

TEST(TreeModel, WithoutTreesScoresItsBase) {
  TreeModel model;
  model.base = 0.75;
  EXPECT_EQ(score(model, {}), 0.75);
}

TEST(TreeModel, ASplitSendsWhatIsBelowTheThresholdLeft) {
  TreeModel model = two_trees();
  model.trees.resize(1);
  EXPECT_EQ(score_of(model, 1.4F, 0.0F), 10.25);
  EXPECT_EQ(score_of(model, 1.5F, 0.0F), 20.25);
  EXPECT_EQ(score_of(model, std::numeric_limits<float>::infinity(), 0.0F), 20.25);
  EXPECT_EQ(score_of(model, std::numeric_limits<float>::quiet_NaN(), 0.0F), 20.25);
}

TEST(TreeModel, TreesAddUp) {
  const TreeModel model = two_trees();
  EXPECT_EQ(score_of(model, 0.0F, -1.0F), 0.25 + 10.0 + 0.5);
  EXPECT_EQ(score_of(model, 3.0F, 0.0F), 0.25 + 20.0 + 1.0);
  EXPECT_EQ(score_of(model, 4.0F, 1.0F), 0.25 + 20.0 + 2.0);
}

TEST(TreeModel, AlikeIsWhatTreesLeadToTheSameLeaf) {
  const TreeModel model = two_trees();
  const auto judged = [&](float a, float b) {
    const std::array<float, 2> features = {a, b};
    return predict(model, features);
  };
  EXPECT_EQ(judged(3.0F, 0.0F).leaves, (std::vector<int>{2, 3}));
  EXPECT_EQ(judged(3.0F, 0.0F).score, score_of(model, 3.0F, 0.0F));
  EXPECT_EQ(likeness(judged(3.0F, 0.0F), judged(2.0F, 7.0F)), 1.0);
  EXPECT_EQ(likeness(judged(3.0F, 0.0F), judged(4.0F, 1.0F)), 0.5);
  EXPECT_EQ(likeness(judged(0.0F, -1.0F), judged(3.0F, 0.0F)), 0.0);
  EXPECT_EQ(likeness(Prediction{}, Prediction{}), 0.0);
}

TEST(TreeModel, RefusesTreesThatWouldNotEnd) {
  const auto refusal = [](const auto& change) {
    TreeModel model = two_trees();
    change(model.trees[1]);
    return std::string(test::refusal_of([&] { check(model); }).what());
  };
  EXPECT_EQ(refusal([](Tree& tree) { tree[2].left = 2; }),
            "trees[1].left[2]: must be a node behind its parent (2)");
  EXPECT_EQ(refusal([](Tree& tree) { tree[2].left = 0; }),
            "trees[1].left[2]: must be a node behind its parent (0)");
  EXPECT_EQ(refusal([](Tree& tree) { tree[0].right = 5; }),
            "trees[1].right[0]: must be a node behind its parent (5)");
  EXPECT_EQ(refusal([](Tree& tree) { tree[0].right = -1; }),
            "trees[1].right[0]: must be a node behind its parent (-1)");
  EXPECT_EQ(refusal([](Tree& tree) { tree[2].feature = 2; }),
            "trees[1].feature[2]: is none of the features (2)");
  EXPECT_EQ(refusal([](Tree& tree) { tree[2].feature = -2; }),
            "trees[1].feature[2]: is none of the features (-2)");
  EXPECT_EQ(refusal([](Tree& tree) { tree.clear(); }), "trees[1]: needs a node");
  EXPECT_NE(refusal([](Tree& tree) { tree[1].value = std::nanf(""); }).find("trees[1].value[1]"),
            std::string::npos);
}

std::string unfit_text(const TreeModel& model, const char* hand) {
  return test::refusal_of([&] { require_fit(model, hand); }).what();
}

TEST(TreeModel, FitsTheHandsItWasTrainedOnOrAny) {
  TreeModel model = two_trees();
  model.features_version = kGraspFeaturesVersion;
  model.features = grasp_feature_names();
  EXPECT_NO_THROW(require_fit(model, "some_hand"));
  EXPECT_EQ(unfit_text(model, "other"),
            "hands: was trained for other hands (some_hand), not for any (other)");
  model.any_hand = true;
  EXPECT_NO_THROW(require_fit(model, "other"));
  model.features.back() = "something else";
  EXPECT_NE(unfit_text(model, "other").find("features: "), std::string::npos);
  model.features_version = kGraspFeaturesVersion + 1;
  EXPECT_NE(unfit_text(model, "other").find("features_version: "), std::string::npos);
}

TEST(TreeModel, AFileReadsBackAsItWas) {
  TreeModel model = two_trees();
  model.trees[0][0].threshold = 0.1F;
  model.trees[0][1].value = std::nextafter(1.0F, 2.0F);
  model.trees[0][2].value = 1e-30F;
  model.base = 1.0 / 3.0;
  const TreeModel back = parse_tree_model("some/folder/mine.json", tree_model_json(model));
  EXPECT_EQ(back.name, "mine");
  EXPECT_EQ(tree_model_json(back), tree_model_json(model));
  EXPECT_EQ(checksum(back), checksum(model));
  EXPECT_EQ(back.trees[0][1].value, model.trees[0][1].value);
  EXPECT_EQ(back.base, model.base);
  EXPECT_EQ(back.hands, model.hands);
}

TEST(TreeModel, AnotherModelHasAnotherChecksum) {
  const TreeModel model = two_trees();
  TreeModel other = model;
  other.trees[1][4].value = 2.5F;
  EXPECT_NE(checksum(model), checksum(other));
  other = model;
  other.any_hand = true;
  EXPECT_NE(checksum(model), checksum(other));
}

// The text with one part replaced, which must be there.
std::string refusal_with(const std::string& part, const std::string& by) {
  std::string text = tree_model_json(two_trees());
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  text.replace(at, part.size(), by);
  return test::refusal_of([&] { (void)parse_tree_model("m.json", text); }).what();
}

TEST(TreeModelFile, RefusesWithFileAndField) {
  EXPECT_NE(refusal_with("\"objects\"", "\"things\"").find("m.json: "), std::string::npos);
  EXPECT_NE(refusal_with("\"any_hand\":false", "\"any_hand\":false,\"more\":1").find("more"),
            std::string::npos);
  EXPECT_NE(refusal_with("prehend trees 1", "prehend trees 2").find("m.json: format: "),
            std::string::npos);
  EXPECT_NE(refusal_with("\"feature\":[0,-1,-1]", "\"feature\":[0,-1]").find("trees[0].threshold"),
            std::string::npos);
  EXPECT_NE(
      refusal_with("\"left\":[1,-1,-1]", "\"left\":[0,-1,-1]").find("m.json: trees[0].left[0]"),
      std::string::npos);
  EXPECT_NE(refusal_with("[0,10,20]", "[0,1e39,20]").find("m.json: trees[0].value[1]"),
            std::string::npos);
  EXPECT_NE(refusal_with("[0,10,20]", "[0,1e999,20]").find("m.json: "), std::string::npos);
  EXPECT_NE(refusal_with("\"trials\":30", "\"trials\":-1").find("m.json: trials"),
            std::string::npos);
  EXPECT_NE(refusal_with("\"base\":0.25,", "").find("m.json: base"), std::string::npos);
}

}  // namespace
}  // namespace prehend
