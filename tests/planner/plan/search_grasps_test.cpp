// The search: how many trials, in which order, and when it ends.
#include "planner/plan/search_grasps.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <numeric>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "planner/plan/learn/grasp_features.h"
#include "planner/plan/learn/tree_model.h"
#include "primitives/decompose.h"
#include "sim/base/index.h"
#include "sim/scene/make_scene.h"
#include "sim/shape/basic_shapes.h"
#include "tests/support/library_scenes.h"
#include "tests/support/scenes.h"

namespace prehend {
namespace {

struct Searched {
  const CompiledScene& scene;
  std::vector<Primitive> primitives;

  SearchResult search(const SearchOptions& options, const RunContext& context = {}) const {
    return search_grasps(scene, primitives, {}, options, {}, context);
  }
};

Searched mug_to_search() {
  static const CompiledScene scene = test::compiled_library_scene("mug");
  return {scene, decompose(scene.scene.object.mesh).primitives};
}

void expect_same(const SearchResult& a, const SearchResult& b, std::size_t trials) {
  for (std::size_t i = 0; i < trials; ++i) {
    const Candidate& c = a.proposed[a.candidates[i]].candidate;
    const Candidate& d = b.proposed[b.candidates[i]].candidate;
    ASSERT_TRUE(c.X_OH.matrix() == d.X_OH.matrix() && c.preshape == d.preshape) << i;
    ASSERT_EQ(a.trials[i].outcome, b.trials[i].outcome) << i;
    ASSERT_EQ(a.trials[i].epsilon.lower, b.trials[i].epsilon.lower) << i;
  }
}

TEST(SearchGrasps, TriesTheSameOnAnyNumberOfThreads) {
  const Searched mug = mug_to_search();
  const SearchResult one = mug.search({.trials = 200}, {.threads = 1});
  const SearchResult two = mug.search({.trials = 200}, {.threads = 2});
  ASSERT_EQ(one.trials.size(), 200U);
  ASSERT_EQ(two.trials.size(), 200U);
  EXPECT_EQ(one.end, SearchEnd::trials);
  expect_same(one, two, 200);
}

// A ranking needs the contacts of what holds, advice those of trials of which none holds.
TEST(SearchGrasps, ForgetsTheContactsOfTrialsThatDoNotHold) {
  const Searched mug = mug_to_search();
  const auto search = [&](bool slips, KeptTrials kept) {
    Scene scene = mug.scene.scene;
    for (const Material of_hand : {Material::plastic, Material::metal, Material::rubber}) {
      if (slips) scene.friction.set(of_hand, Material::plastic, 0.0);
    }
    return search_grasps(compile(std::move(scene)), mug.primitives, {}, {.trials = 100}, {}, {}, {},
                         kept);
  };
  const SearchResult whole = search(false, KeptTrials::whole);
  const SearchResult holding = search(false, KeptTrials::holding);
  expect_same(whole, holding, 100);
  for (std::size_t i = 0; i < 100; ++i) {
    const Trial& kept = holding.trials[i];
    EXPECT_EQ(kept.outcome == Outcome::stable, !kept.contacts.empty()) << i;
    EXPECT_EQ(kept.joints.empty(), kept.contacts.empty()) << i;
    EXPECT_FALSE(whole.trials[i].contacts.empty()) << i;
  }
  for (const Trial& trial : search(true, KeptTrials::holding).trials) {
    EXPECT_FALSE(trial.contacts.empty());
  }
}

// Likes thick places, of this hand.
LearnedOrder order_by_thickness(const CompiledScene& scene) {
  auto model = std::make_shared<TreeModel>();
  model->features_version = kGraspFeaturesVersion;
  model->features = grasp_feature_names();
  model->hands = {scene.scene.hand.name};
  const auto at = std::find(model->features.begin(), model->features.end(), "thickness");
  const auto feature = static_cast<int>(at - model->features.begin());
  for (const float threshold : {0.1F, 0.2F, 0.4F, 0.6F}) {
    model->trees.push_back(
        {{feature, threshold, 1, 2, 0.0F}, {-1, 0.0F, -1, -1, 0.0F}, {-1, 0.0F, -1, -1, 1.0F}});
  }
  LearnedOrder order;
  order.model = std::move(model);
  return order;
}

TEST(SearchGrasps, ALearnedOrderIsTheSameOnAnyNumberOfThreads) {
  const Searched mug = mug_to_search();
  SearchOptions options{.trials = 160};
  options.learned = order_by_thickness(mug.scene);
  const SearchResult one = mug.search(options, {.threads = 1});
  ASSERT_EQ(one.trials.size(), one.candidates.size());
  for (const int threads : {2, 4}) {
    const SearchResult many = mug.search(options, {.threads = threads});
    ASSERT_EQ(many.trials.size(), one.trials.size());
    expect_same(one, many, one.trials.size());
  }
  // It does choose others than the search without it.
  const SearchResult without = mug.search({.trials = 160});
  int different = 0;
  for (std::size_t i = 0; i < 100; ++i) {
    if (one.proposed[i].candidate.X_OH.matrix() != without.proposed[i].candidate.X_OH.matrix()) {
      ++different;
    }
  }
  EXPECT_GT(different, 50);
}

// With none that are ordered, the search is the one without a model.
TEST(SearchGrasps, AnOrderThatChangesNothingChangesNothing) {
  const Searched mug = mug_to_search();
  SearchOptions options{.trials = 128};
  options.learned = order_by_thickness(mug.scene);
  options.learned->ordered_first = 0;
  const SearchResult with = mug.search(options);
  const SearchResult without = mug.search({.trials = 128});
  ASSERT_EQ(with.trials.size(), without.trials.size());
  expect_same(with, without, with.trials.size());
}

// Whole batches of a shorter search are those of a longer one, so that more trials never lose a
// grasp.
TEST(SearchGrasps, MoreTrialsGoOnWhereFewerEnd) {
  const Searched mug = mug_to_search();
  const SearchResult few = mug.search({.trials = 96, .batch = 32});
  const SearchResult many = mug.search({.trials = 160, .batch = 32});
  expect_same(few, many, 96);
}

// What lies beside the best grasps so far is better than the sequence by itself, and of a finer
// level than the sequence has come to.
TEST(SearchGrasps, FollowsTheBest) {
  const SearchResult result = mug_to_search().search({.trials = 200});
  double beside = 0.0;
  double others = 0.0;
  int beside_count = 0;
  for (std::size_t i = 0; i < result.trials.size(); ++i) {
    const Trial& trial = result.trials[i];
    const double epsilon = trial.outcome == Outcome::stable ? trial.epsilon.lower : 0.0;
    const bool is_beside = result.proposed[result.candidates[i]].level > 0;
    (is_beside ? beside : others) += epsilon;
    beside_count += is_beside ? 1 : 0;
  }
  ASSERT_GT(beside_count, 20);
  EXPECT_LT(beside_count, 80);
  EXPECT_GT(beside / beside_count, 1.5 * others / (200 - beside_count));
  const SearchResult without = mug_to_search().search({.trials = 200, .local_fraction = 0.0});
  for (const ProposedGrasp& grasp : without.proposed) EXPECT_EQ(grasp.level, 0);
}

// The batch in which the last of them is found is tried to its end, on any number of threads.
TEST(SearchGrasps, EndsOnceEnoughGraspsHold) {
  const Searched mug = mug_to_search();
  const SearchResult all = mug.search({.trials = 200});
  for (const int enough : {1, 30}) {
    const SearchResult some = mug.search({.trials = 200, .enough = enough}, {.threads = 2});
    EXPECT_EQ(some.end, SearchEnd::enough);
    EXPECT_EQ(some.trials.size() % 32, 0U);
    const auto stable_in = [&](std::size_t count) {
      return std::count_if(some.trials.begin(),
                           some.trials.begin() + static_cast<std::ptrdiff_t>(count),
                           [](const Trial& t) { return t.outcome == Outcome::stable; });
    };
    EXPECT_GE(stable_in(some.trials.size()), enough);
    EXPECT_LT(stable_in(some.trials.size() - 32), enough);
    expect_same(some, all, some.trials.size());
  }
}

// The beginning of the whole search, up to a batch in which the best ten grasps did not become
// better by 1 %: it has more trials than the setting asks for.
TEST(SearchGrasps, EndsWhenTheBestGetNoBetter) {
  const Searched mug = mug_to_search();
  const SearchResult all = mug.search({.trials = 400, .settled = 1.0});
  const SearchResult some = mug.search({.trials = 400, .settled = 0.05}, {.threads = 2});
  EXPECT_EQ(some.end, SearchEnd::settled);
  ASSERT_LT(some.trials.size(), all.trials.size());
  expect_same(some, all, some.trials.size());
  const auto best_ten = [&](std::size_t count) {
    std::vector<double> epsilons(10, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      if (all.trials[i].outcome == Outcome::stable) {
        epsilons.push_back(all.trials[i].epsilon.lower);
      }
    }
    std::sort(epsilons.begin(), epsilons.end(), std::greater<>());
    return std::accumulate(epsilons.begin(), epsilons.begin() + 10, 0.0);
  };
  EXPECT_LE(best_ten(some.trials.size()), 1.01 * best_ten(some.trials.size() - 32));
}

// The knuckles of the open Robotiq 2F-85 meet the upper edges of a wide box before its pads do: it
// holds the box only farther out than a trial backs off.
TEST(SearchGrasps, BacksOffWhereNothingHolds) {
  const CompiledScene scene = compile(make_scene(
      make_graspable("box", make_box({0.06, 0.1, 0.16}), Material::plastic), "robotiq_2f85"));
  const Searched box{scene, decompose(scene.scene.object.mesh).primitives};
  const SearchResult never = box.search({.trials = 120, .trials_before_back_offs = 120});
  EXPECT_EQ(std::count_if(never.trials.begin(), never.trials.end(),
                          [](const Trial& t) { return t.outcome == Outcome::stable; }),
            0);
  const SearchResult soon =
      box.search({.trials = 120, .trials_before_back_offs = 60}, {.threads = 2});
  expect_same(never, soon, 64);
  for (std::size_t i = 64; i < soon.trials.size(); ++i) {
    const Trial& trial = soon.trials[i];
    EXPECT_TRUE(trial.outcome != Outcome::stable || trial.back_offs > 1) << i;
  }
  EXPECT_EQ(soon.trials.back().outcome, Outcome::stable);
}

TEST(SearchGrasps, BeginsNothingAfterItsDeadline) {
  const Searched mug = mug_to_search();
  RunContext context;
  context.deadline = Deadline::in(1e-9);
  const SearchResult none = mug.search({.trials = 100}, context);
  EXPECT_EQ(none.end, SearchEnd::out_of_time);
  EXPECT_TRUE(none.trials.empty());
  EXPECT_EQ(none.families_untested, none.families);
  EXPECT_GT(none.families, 0);
}

// A deadline that passes in the middle: what was tried by then is the beginning of the whole.
TEST(SearchGrasps, OutOfTimeIsABeginning) {
  const Searched mug = mug_to_search();
  RunContext context{.threads = 1};
  context.progress = [&](const Progress& progress) {
    if (progress.done == 70) context.deadline = Deadline::in(1e-9);
  };
  const SearchResult some = mug.search({.trials = 200}, context);
  EXPECT_EQ(some.end, SearchEnd::out_of_time);
  ASSERT_EQ(some.trials.size(), 70U);
  expect_same(some, mug.search({.trials = 200}, {.threads = 1}), 70);
}

TEST(SearchGrasps, WithoutAnyPrimitiveEndsAtOnce) {
  const Searched mug = mug_to_search();
  const SearchResult none = Searched{mug.scene, {}}.search({});
  EXPECT_EQ(none.end, SearchEnd::no_proposal);
  EXPECT_TRUE(none.trials.empty());
}

// A box in a narrow pit: no hand gets to it, and the search gives up after most_blocked times the
// trials that were asked for.
TEST(SearchGrasps, EndsWhereEveryHandIsBlocked) {
  Scene scene =
      make_scene(make_graspable("box", make_box(Vector3(0.04, 0.04, 0.04)), Material::plastic),
                 "parallel_jaw");
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 side = Vector3::Unit(axis);
    for (const double sign : {1.0, -1.0}) {
      add_obstacle(scene, "wall " + std::to_string(2 * axis + (sign > 0.0 ? 1 : 0)),
                   make_box(Vector3(0.3, 0.3, 0.3) - 0.25 * side), translation(sign * 0.06 * side));
    }
  }
  const CompiledScene compiled = compile(std::move(scene));
  const Searched pit{compiled, decompose(compiled.scene.object.mesh).primitives};
  const SearchResult result = pit.search({.trials = 10, .most_blocked = 5});
  EXPECT_EQ(result.end, SearchEnd::blocked);
  EXPECT_GT(result.trials.size(), 50U);
  EXPECT_LT(result.trials.size(), 100U);
  for (const Trial& trial : result.trials) EXPECT_TRUE(is_blocked(trial.outcome));
}

}  // namespace
}  // namespace prehend
