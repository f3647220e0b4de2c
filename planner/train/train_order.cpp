#include "planner/train/train_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/learn/grasp_features.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

void add_name(std::vector<std::string>& names, const std::string& name) {
  const auto place = std::lower_bound(names.begin(), names.end(), name);
  if (place == names.end() || *place != name) names.insert(place, name);
}

// Whether the trial tells something of the hand and the object.
bool is_example(const GraspSetEntry& grasp) {
  return !grasp.features.empty() && grasp.outcome != Outcome::unreachable &&
         grasp.outcome != Outcome::arm_blocked;
}

double epsilon_of(const GraspSetEntry& grasp) {
  return grasp.outcome == Outcome::stable ? grasp.epsilon.lower : 0.0;
}

}  // namespace

void OrderTraining::add(const GraspSet& set) {
  double best = 0.0;
  unsigned count = 0;
  for (const GraspSetEntry& grasp : set.grasps) {
    if (!is_example(grasp)) continue;
    best = std::max(best, epsilon_of(grasp));
    ++count;
  }
  if (count == 0 || !(best > 0.0)) return;
  require(set.feature_names == grasp_feature_names(),
          {.field = "features", .problem = "are not those that this version computes"});
  for (const GraspSetEntry& grasp : set.grasps) {
    if (!is_example(grasp)) continue;
    require(grasp.features.size() == kGraspFeatures.size(),
            {.field = "features", .problem = "needs a number for each name"});
    rows_.values.insert(rows_.values.end(), grasp.features.begin(), grasp.features.end());
    const double share = epsilon_of(grasp) / best;
    rows_.labels.push_back(static_cast<float>(std::pow(share, options_.power)));
  }
  rows_.groups.push_back(count);
  add_name(hands_, set.hand);
  add_name(objects_, set.object.file);
}

TreeModel OrderTraining::train() const {
  require(!rows_.labels.empty(),
          {.problem = "no set of grasps has features and a grasp that holds"});
  BoostRows rows = rows_;
  rows.features = kGraspFeatures.size();
  BoostedTrees boosted = boost_trees(rows, options_.boost);
  TreeModel model;
  model.features_version = kGraspFeaturesVersion;
  model.features = grasp_feature_names();
  model.hands = hands_;
  model.any_hand = options_.any_hand || static_cast<int>(hands_.size()) >= kManyHands;
  model.objects = static_cast<int>(objects_.size());
  model.trials = static_cast<int>(rows.labels.size());
  model.base = boosted.base;
  model.trees = std::move(boosted.trees);
  check(model);
  return model;
}

TreeModel train_order(const std::vector<GraspSet>& sets, const TrainOptions& options) {
  OrderTraining training(options);
  for (const GraspSet& set : sets) training.add(set);
  return training.train();
}

}  // namespace prehend
