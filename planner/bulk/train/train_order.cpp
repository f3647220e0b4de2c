#include "planner/bulk/train/train_order.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/plan/learn/grasp_features.h"
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

// Of these, which are sorted; 0 for what does not hold.
double part_not_better(const std::vector<double>& epsilons, double epsilon) {
  if (!(epsilon > 0.0)) return 0.0;
  const auto better = std::upper_bound(epsilons.begin(), epsilons.end(), epsilon);
  return static_cast<double>(better - epsilons.begin()) / static_cast<double>(epsilons.size());
}

}  // namespace

void OrderTraining::add(const GraspSet& set) {
  std::vector<double> epsilons;
  for (const GraspSetEntry& grasp : set.grasps) {
    if (is_example(grasp)) epsilons.push_back(epsilon_of(grasp));
  }
  std::sort(epsilons.begin(), epsilons.end());
  if (epsilons.empty() || !(epsilons.back() > 0.0)) return;
  require(set.feature_names == grasp_feature_names(),
          {.field = "features", .problem = "are not those that this version computes"});
  for (const GraspSetEntry& grasp : set.grasps) {
    if (!is_example(grasp)) continue;
    require(grasp.features.size() == kGraspFeatures.size(),
            {.field = "features", .problem = "needs a number for each name"});
    rows_.values.insert(rows_.values.end(), grasp.features.begin(), grasp.features.end());
    const double part = part_not_better(epsilons, epsilon_of(grasp));
    rows_.labels.push_back(static_cast<float>(std::pow(part, options_.power)));
  }
  rows_.groups.push_back(static_cast<unsigned>(epsilons.size()));
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
