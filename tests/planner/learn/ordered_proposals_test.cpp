// The order that a model gives to proposals: none is lost, none comes twice, and a share keeps the
// order of the sequence.
#include "planner/learn/ordered_proposals.h"

#include <algorithm>
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

  LearnedOrder likes(const char* name, double unordered, double choose_from = 4.0) const {
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
    return {model, choose_from, unordered};
  }

  std::vector<ProposedGrasp> in_sequence(int count) const {
    ProposalSequence sequence(scene, primitives, {});
    std::vector<ProposedGrasp> grasps;
    for (int i = 0; i < count; ++i) grasps.push_back(*sequence.next(Track::solids));
    return grasps;
  }

  std::vector<ProposedGrasp> ordered(const LearnedOrder& order, int count, int batch = 8) const {
    ProposalSequence sequence(scene, primitives, {});
    OrderedProposals proposals(scene, primitives, sequence, order, batch);
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

TEST(OrderedProposals, EveryProposalComesOnceAndNoneIsLost) {
  const Ordering scene;
  constexpr int kTaken = 150;
  constexpr int kPool = 32;  // 4 batches of 8
  for (const double unordered : {0.2, 0.5}) {
    const auto ordered = scene.ordered(scene.likes("thickness", unordered), kTaken);
    const auto sequence = scene.in_sequence(kTaken + kPool);
    const std::set<Key> taken = keys(ordered, 0, kTaken);
    EXPECT_EQ(taken.size(), static_cast<std::size_t>(kTaken));
    const std::set<Key> drawn = keys(sequence, 0, sequence.size());
    EXPECT_TRUE(std::includes(drawn.begin(), drawn.end(), taken.begin(), taken.end()));
    // What waits longest is the next of the unordered part: a fifth of what was taken is enough for
    // the beginning of the sequence to have come.
    const auto begun = static_cast<std::size_t>(unordered * kTaken);
    const std::set<Key> first = keys(sequence, 0, begun);
    EXPECT_TRUE(std::includes(taken.begin(), taken.end(), first.begin(), first.end()));
  }
}

TEST(OrderedProposals, AllUnorderedIsTheSequence) {
  const Ordering scene;
  const auto ordered = scene.ordered(scene.likes("thickness", 1.0), 100);
  const auto sequence = scene.in_sequence(100);
  for (std::size_t i = 0; i < 100; ++i) EXPECT_EQ(key(ordered[i]), key(sequence[i])) << i;
}

TEST(OrderedProposals, TheBestOfThePoolComesFirst) {
  const Ordering scene;
  const LearnedOrder order = scene.likes("before", 0.0);
  const auto ordered = scene.ordered(order, 32);
  const FeatureMaker maker(scene.scene, scene.primitives);
  const auto score_of = [&](const ProposedGrasp& grasp) {
    return score(*order.model, maker.features(grasp));
  };
  const auto sequence = scene.in_sequence(32);
  double best = 0.0;
  for (const ProposedGrasp& grasp : sequence) best = std::max(best, score_of(grasp));
  EXPECT_EQ(score_of(ordered.front()), best);
  // What was worse than another of the pool came after it.
  double first = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < 32; ++i) {
    if (i < 16) first += score_of(ordered[i]) / 16.0;
    all += score_of(sequence[i]) / 32.0;
  }
  EXPECT_GT(first, all);
}

TEST(OrderedProposals, AShareKeepsTheOrderOfTheSequence) {
  const Ordering scene;
  const auto ordered = scene.ordered(scene.likes("before", 0.25), 80);
  const auto sequence = scene.in_sequence(80);
  // Every fourth is the earliest proposal that was not taken before.
  std::set<Key> taken;
  std::size_t earliest = 0;
  for (std::size_t i = 0; i < 80; ++i) {
    while (taken.count(key(sequence[earliest])) > 0) ++earliest;
    if (i % 4 == 3) {
      EXPECT_EQ(key(ordered[i]), key(sequence[earliest])) << i;
    }
    taken.insert(key(ordered[i]));
  }
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
