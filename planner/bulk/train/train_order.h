// From sets of grasps that were tried to a model that orders candidates.
#pragma once

#include <vector>

#include "planner/bulk/train/boost_trees.h"
#include "planner/results/datasets/grasp_set.h"

namespace prehend {

struct TrainOptions {
  // What is learnt of a trial is the part of its set that is no better, to this power (> 0): 1 for
  // the best of the set, 0 for a grasp that does not hold. The larger the power, the more the model
  // cares for the best alone.
  double power = 4.0;
  BoostOptions boost;
  bool any_hand = false;  // the model may be used for hands that it was not trained on
};

// So many hands make a model one for any hand without being asked.
inline constexpr int kManyHands = 3;

// Collects examples set by set, so that not all sets have to be in memory.
class OrderTraining {
 public:
  explicit OrderTraining(const TrainOptions& options) : options_(options) {}

  // Adds the grasps of a set that have features, except those that only the arm kept from being
  // tried. A set without any stable grasp tells nothing of an order and is left out. Throws
  // InputError where the features are not those of this version (grasp_features.h).
  void add(const GraspSet& set);

  // The model of all sets so far. Throws InputError where no set had examples, and as boost_trees.
  TreeModel train() const;

 private:
  TrainOptions options_;
  BoostRows rows_;
  std::vector<std::string> hands_;    // sorted
  std::vector<std::string> objects_;  // sorted
};

TreeModel train_order(const std::vector<GraspSet>& sets, const TrainOptions& options = {});

}  // namespace prehend
