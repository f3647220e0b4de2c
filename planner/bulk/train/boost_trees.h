// Gradient-boosted trees by xgboost, where the program was built with it: the only file to know it.
#pragma once

#include <cstdint>
#include <vector>

#include "planner/plan/learn/tree_model.h"

namespace prehend {

// A table of examples.
struct BoostRows {
  std::size_t features = 0;   // values in a row, >= 1
  std::vector<float> values;  // row after row, finite
  std::vector<float> labels;  // one a row
  std::vector<unsigned>
      groups;  // numbers of rows that belong together, for ranks; their sum is all
};

// What the trees are to predict.
enum class BoostGoal {
  value,  // the label: least squares
  order,  // the order of the labels within each group (xgboost's rank:pairwise, after LambdaMART)
};

// How trees are grown (see the parameters of xgboost with these names).
struct BoostOptions {
  BoostGoal goal = BoostGoal::value;
  int trees = 300;             // >= 1
  int depth = 9;               // >= 1
  double learning_rate = 0.1;  // in (0, 1]
  double least_weight = 10.0;  // min_child_weight, >= 0
  double rows_part = 0.7;      // subsample, in (0, 1]
  double columns_part = 0.7;   // colsample_bytree, in (0, 1]
  std::uint64_t seed = 1;
};

// Trees and the score before them.
struct BoostedTrees {
  double base = 0.0;
  std::vector<Tree> trees;
};

// Whether the program was built with xgboost.
bool can_boost();
// Throws InputError, with the package to install, where it was not.
void require_training();

// Grows trees by histograms, on one thread: the same arguments give the same trees. Throws
// InputError where there are no rows, and, with the package to install, without xgboost.
BoostedTrees boost_trees(const BoostRows& rows, const BoostOptions& options);

// What xgboost itself predicts for rows of these trees, as a reference for tests: grows them again.
std::vector<float> boosted_predictions(const BoostRows& rows, const BoostOptions& options);

}  // namespace prehend
