// The order that a model gives to proposals: the best and most various first, none is lost, none
// comes twice, and a share keeps the order of the sequence.
#include "planner/plan/learn/ordered_proposals.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/shape/basic_shapes.h"
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
          {{feature, threshold, 1, 2, 0.0F}, {-1, 0.0F, -1, -1, 0.0F}, {-1, 0.0F, -1, -1, 0.1F}});
    }
    return {.model = model,
            .choose_from = 24,
            .variety = 0.0,
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
    OrderedProposals proposals(scene, primitives, {}, sequence, order);
    std::vector<ProposedGrasp> grasps;
    for (int i = 0; i < count; ++i) grasps.push_back(*proposals.next(Track::solids));
    return grasps;
  }

  std::vector<Prediction> judged(const LearnedOrder& order,
                                 const std::vector<ProposedGrasp>& grasps) const {
    const FeatureMaker maker(scene, primitives);
    std::vector<Prediction> judgements;
    for (const ProposedGrasp& grasp : grasps) {
      judgements.push_back(predict(*order.model, maker.features(grasp)));
    }
    return judgements;
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

// What comes where the best of 24 that wait is chosen each time, by the definition: each choice
// looks at all that came before it.
std::vector<std::size_t> chosen_by_definition(const std::vector<Prediction>& judged, double variety,
                                              std::size_t count) {
  std::vector<std::size_t> chosen;
  while (chosen.size() < count) {
    std::optional<std::size_t> best;
    double most = 0.0;
    std::size_t waiting = 0;
    for (std::size_t i = 0; waiting < 24; ++i) {
      if (std::find(chosen.begin(), chosen.end(), i) != chosen.end()) continue;
      ++waiting;
      double alike = 0.0;
      for (const std::size_t c : chosen) alike = std::max(alike, likeness(judged[i], judged[c]));
      const double merit = judged[i].score - variety * alike * alike;
      if (best && merit <= most) continue;
      best = i;
      most = merit;
    }
    chosen.push_back(*best);
  }
  return chosen;
}

TEST(OrderedProposals, TheBestAndLeastAlikeOfThoseThatWaitComeFirst) {
  const Ordering scene;
  const auto sequence = scene.in_sequence(100);
  std::set<std::vector<std::size_t>> orders;
  for (const double variety : {0.0, 0.3, 20.0}) {
    LearnedOrder order = scene.likes("before", 0.0);
    order.variety = variety;
    const auto expected = chosen_by_definition(scene.judged(order, sequence), variety, 60);
    const auto ordered = scene.ordered(order, 60);
    for (std::size_t i = 0; i < 60; ++i) {
      EXPECT_EQ(key(ordered[i]), key(sequence[expected[i]])) << variety << ' ' << i;
    }
    orders.insert(expected);
  }
  EXPECT_GE(orders.size(), 2U);
}

TEST(OrderedProposals, EveryProposalComesOnceAndNoneIsLost) {
  const Ordering scene;
  constexpr std::size_t kTaken = 150;
  for (const double unordered : {0.2, 0.5}) {
    LearnedOrder order = scene.likes("thickness", unordered);
    order.variety = 1.0;
    const auto ordered = scene.ordered(order, kTaken);
    const auto sequence = scene.in_sequence(kTaken + 24);
    const std::set<Key> taken = keys(ordered, 0, kTaken);
    EXPECT_EQ(taken.size(), kTaken);
    const std::set<Key> drawn = keys(sequence, 0, sequence.size());
    EXPECT_TRUE(std::includes(drawn.begin(), drawn.end(), taken.begin(), taken.end()));
    // The first of the sequence were taken: none is put off for ever.
    const auto in_turn = static_cast<std::size_t>(unordered * kTaken);
    const std::set<Key> first = keys(sequence, 0, in_turn);
    EXPECT_TRUE(std::includes(taken.begin(), taken.end(), first.begin(), first.end()));
  }
}

TEST(OrderedProposals, AShareComesInTheOrderOfTheSequence) {
  const Ordering scene;
  const auto ordered = scene.ordered(scene.likes("before", 0.25), 80);
  const auto sequence = scene.in_sequence(200);
  std::set<Key> taken;
  int out_of_order = 0;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    std::size_t first = 0;
    while (taken.count(key(sequence[first])) > 0) ++first;
    const bool is_first = key(ordered[i]) == key(sequence[first]);
    EXPECT_TRUE(is_first || i % 4 != 3) << i;
    if (!is_first) ++out_of_order;
    taken.insert(key(ordered[i]));
  }
  EXPECT_GT(out_of_order, 30);
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

// A model is used for an unknown hand where its scores rank the first proposals, which are those of
// the sequence; where it ranks them the other way round, all are.
TEST(OrderedProposals, AnUnknownHandChecksTheModelFirst) {
  const Ordering scene;
  LearnedOrder order = scene.likes("before", 0.0);
  auto model = std::make_shared<TreeModel>(*order.model);
  model->hands = {"another"};
  model->any_hand = true;
  order.model = model;
  order.unknown_hand_first = 20;
  const auto in_order = scene.in_sequence(100);
  const std::vector<Prediction> judged = scene.judged(order, in_order);
  for (const double sign : {1.0, -1.0}) {
    ProposalSequence sequence(scene.scene, scene.primitives, {});
    OrderedProposals proposals(scene.scene, scene.primitives, {}, sequence, order);
    bool all_in_order = true;
    for (std::size_t i = 0; i < 60; ++i) {
      const ProposedGrasp grasp = *proposals.next(Track::solids);
      all_in_order = all_in_order && key(grasp) == key(in_order[i]);
      if (i < 20) {
        EXPECT_TRUE(all_in_order) << i;
        proposals.tell(grasp, 10.0 + sign * judged[i].score);
      }
    }
    EXPECT_EQ(all_in_order, sign < 0.0);
  }
}

// What waits counts as proposed only when it comes, and what was proposed beside a grasp does not
// come again.
TEST(OrderedProposals, WhatWaitsIsStillBesideOthers) {
  const Ordering scene;
  ProposalSequence plain(scene.scene, scene.primitives, {});
  const ProposedGrasp first = *plain.next(Track::solids);
  const std::vector<ProposedGrasp> expected = plain.beside(first);
  ASSERT_FALSE(expected.empty());
  LearnedOrder order = scene.likes("before", 1.0);
  order.choose_from = 2000;
  ProposalSequence sequence(scene.scene, scene.primitives, {});
  OrderedProposals proposals(scene.scene, scene.primitives, {}, sequence, order);
  ASSERT_EQ(key(*proposals.next(Track::solids)), key(first));
  const std::vector<ProposedGrasp> beside = sequence.beside(first);
  ASSERT_EQ(keys(beside, 0, beside.size()), keys(expected, 0, expected.size()));
  const std::set<Key> found = keys(beside, 0, beside.size());
  for (int i = 0; i < 800; ++i) EXPECT_EQ(found.count(key(*proposals.next(Track::solids))), 0U);
}

// The model chooses a curve although a solid was asked for; in the order of the sequence it is a
// solid.
TEST(OrderedProposals, SolidsAndCurvesCompete) {
  Ordering scene;
  scene.primitives.push_back(
      {Bar{{Vector3(0.0, 0.0, -0.05), Vector3(0.0, 0.0, 0.05)}, 0.01, false}, Pose::Identity()});
  LearnedOrder order = scene.likes("bar", 0.5);
  const auto ordered = scene.ordered(order, 12);
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    EXPECT_EQ(ordered[i].primitive == 2, i % 2 == 0) << i;
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
