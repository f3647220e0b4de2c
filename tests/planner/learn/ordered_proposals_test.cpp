// The order that a model gives to proposals: none is lost, none comes twice, and a share keeps the
// order of the sequence.
#include "planner/learn/ordered_proposals.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/geometry/basic_shapes.h"
#include "tests/support/refusal_of.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

// A scene with a box, and a model that likes a larger value of one feature.
struct Ordering {
  CompiledScene scene = test::compiled(find_robot("barrett"), make_box({0.05, 0.06, 0.09}));
  std::vector<Primitive> primitives = {{Box{{0.05, 0.06, 0.09}}, Pose::Identity()},
                                       {Cylinder{0.03, 0.09}, Pose::Identity()}};

  LearnedOrder likes(const char* name, double unordered) const {
    auto model = std::make_shared<TreeModel>();
    model->features_version = kGraspFeaturesVersion;
    model->features = grasp_feature_names();
    model->hands = {scene.scene.hand.name};
    const auto at = std::find(model->features.begin(), model->features.end(), name);
    const int feature = static_cast<int>(at - model->features.begin());
    for (float threshold = 0.0F; threshold < 4.0F; threshold += 0.05F) {
      model->trees.push_back(
          {{feature, threshold, 1, 2, 0.0F}, {-1, 0.0F, -1, -1, 0.0F}, {-1, 0.0F, -1, -1, 1.0F}});
    }
    return {.model = model,
            .choose_from = 8,
            .chosen = 2,
            .unordered = unordered,
            .ordered_first = 1000};
  }

  std::vector<ProposedGrasp> in_sequence(int count) const {
    ProposalSequence sequence(scene, primitives, {});
    std::vector<ProposedGrasp> grasps;
    for (int i = 0; i < count; ++i) grasps.push_back(*sequence.next(Track::solids));
    return grasps;
  }

  std::vector<ProposedGrasp> ordered(const LearnedOrder& order, int count) const {
    ProposalSequence sequence(scene, primitives, {});
    OrderedProposals proposals(scene, primitives, sequence, order);
    std::vector<ProposedGrasp> grasps;
    for (int i = 0; i < count; ++i) grasps.push_back(*proposals.next(Track::solids));
    return grasps;
  }
};

// What tells a proposal from all others.
using Key = std::pair<int, std::vector<double>>;
Key key(const ProposedGrasp& grasp) { return {grasp.way, grasp.choices}; }

std::set<Key> keys(const std::vector<ProposedGrasp>& grasps, std::size_t first, std::size_t last) {
  std::set<Key> found;
  for (std::size_t i = first; i < last; ++i) found.insert(key(grasps[i]));
  return found;
}

// What is taken are proposals of the sequence; how many of these were drawn for it follows from the
// numbers of the order.
TEST(OrderedProposals, EveryProposalComesOnceAndNoneIsLost) {
  const Ordering scene;
  constexpr int kTaken = 150;
  for (const double unordered : {0.2, 0.5}) {
    const auto ordered = scene.ordered(scene.likes("thickness", unordered), kTaken);
    const auto sequence = scene.in_sequence(4 * kTaken + 8);
    const std::set<Key> taken = keys(ordered, 0, kTaken);
    EXPECT_EQ(taken.size(), static_cast<std::size_t>(kTaken));
    const std::set<Key> drawn = keys(sequence, 0, sequence.size());
    EXPECT_TRUE(std::includes(drawn.begin(), drawn.end(), taken.begin(), taken.end()));
    // Of what the model did not choose, the first were taken: none is put off for ever.
    const std::set<Key> first = keys(sequence, 0, static_cast<std::size_t>(unordered * kTaken) - 1);
    EXPECT_TRUE(std::includes(taken.begin(), taken.end(), first.begin(), first.end()));
  }
}

// Each of its parts is one proposal of the eight that follow each other in the sequence.
TEST(OrderedProposals, TheBestOfEveryEightComeFirst) {
  const Ordering scene;
  const LearnedOrder order = scene.likes("before", 0.0);
  const auto ordered = scene.ordered(order, 20);
  const auto sequence = scene.in_sequence(80);
  const FeatureMaker maker(scene.scene, scene.primitives);
  const auto score_of = [&](const ProposedGrasp& grasp) {
    return score(*order.model, maker.features(grasp));
  };
  bool one_was_better = false;
  for (std::size_t round = 0; round < 10; ++round) {
    std::vector<double> scores;
    for (std::size_t i = 8 * round; i < 8 * round + 8; ++i) scores.push_back(score_of(sequence[i]));
    std::sort(scores.begin(), scores.end(), std::greater<>());
    EXPECT_EQ(score_of(ordered[2 * round]), scores[0]);
    EXPECT_EQ(score_of(ordered[2 * round + 1]), scores[1]);
    one_was_better = one_was_better || scores[1] > scores[2];
    const std::set<Key> eight = keys(sequence, 8 * round, 8 * round + 8);
    EXPECT_EQ(eight.count(key(ordered[2 * round])), 1U);
    EXPECT_EQ(eight.count(key(ordered[2 * round + 1])), 1U);
  }
  EXPECT_TRUE(one_was_better);
}

TEST(OrderedProposals, AShareIsWhatWaitsInTheOrderOfTheSequence) {
  const Ordering scene;
  const auto chosen = scene.ordered(scene.likes("before", 0.0), 60);
  const auto ordered = scene.ordered(scene.likes("before", 0.25), 80);
  const auto sequence = scene.in_sequence(240);
  const std::set<Key> preferred = keys(chosen, 0, chosen.size());
  std::size_t next_chosen = 0;
  std::size_t next_waiting = 0;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    if (i % 4 != 3) {
      EXPECT_EQ(key(ordered[i]), key(chosen[next_chosen++])) << i;
      continue;
    }
    while (preferred.count(key(sequence[next_waiting])) > 0) ++next_waiting;
    EXPECT_EQ(key(ordered[i]), key(sequence[next_waiting++])) << i;
  }
}

// Behind the ordered ones, all that wait come in the order of the sequence, and then the sequence.
TEST(OrderedProposals, BehindTheFirstTheSequenceGoesOn) {
  const Ordering scene;
  LearnedOrder order = scene.likes("before", 0.25);
  order.ordered_first = 16;
  const auto ordered = scene.ordered(order, 200);
  const auto sequence = scene.in_sequence(200);
  EXPECT_EQ(keys(ordered, 0, 200), keys(sequence, 0, 200));
  order.ordered_first = 1000;
  const auto always = scene.ordered(order, 16);
  std::set<Key> taken;
  for (std::size_t i = 0; i < 16; ++i) {
    EXPECT_EQ(key(ordered[i]), key(always[i])) << i;
    taken.insert(key(ordered[i]));
  }
  std::size_t next = 0;
  for (std::size_t i = 16; i < 200; ++i) {
    while (taken.count(key(sequence[next])) > 0) ++next;
    EXPECT_EQ(key(ordered[i]), key(sequence[next++])) << i;
  }
}

TEST(OrderedProposals, ChoosingAllIsTheSequenceInRounds) {
  const Ordering scene;
  LearnedOrder order = scene.likes("before", 0.0);
  order.choose_from = 1;
  const auto ordered = scene.ordered(order, 100);
  const auto sequence = scene.in_sequence(100);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(key(ordered[i]), key(sequence[i])) << i;
}

TEST(OrderedProposals, RefusesAModelOfAnotherHand) {
  const Ordering scene;
  LearnedOrder order = scene.likes("before", 0.2);
  auto model = std::make_shared<TreeModel>(*order.model);
  model->hands = {"another"};
  order.model = model;
  EXPECT_EQ(test::refusal_of([&] { (void)scene.ordered(order, 1); }).field(), "hands");
}

}  // namespace
}  // namespace prehend
