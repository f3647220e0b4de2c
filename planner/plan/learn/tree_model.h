// A sum of decision trees: what was learnt from earlier trials, and how it judges a candidate.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace prehend {

// A node of a decision tree. An inner node sends what has a value of its feature below the
// threshold to `left`, all else to `right`; the children stand behind their parent in the list.
struct TreeNode {
  int feature = -1;  // index into TreeModel::features; -1: a leaf
  float threshold = 0.0F;
  int left = -1;  // indices into the list of nodes
  int right = -1;
  float value = 0.0F;  // of a leaf
};

// The first node is the root.
using Tree = std::vector<TreeNode>;

// Trees that were trained on trials (planner/bulk/train). The larger the score of a candidate, the
// better; those of candidates for the same object and hand are about 0 (bad) .. 1 (the best).
struct TreeModel {
  std::string name;  // what files of results call it
  int features_version = 0;
  std::vector<std::string> features;  // their names, in the order of the indices
  std::vector<std::string> hands;     // whose trials it was trained on
  bool any_hand = false;              // whether it may be used for others as well
  int objects = 0;                    // in the training data
  int trials = 0;                     // in the training data
  double base = 0.0;                  // score before the first tree
  std::vector<Tree> trees;
};

// What a model says of a candidate.
struct Prediction {
  double score = 0.0;
  std::vector<int> leaves;  // to which each tree leads, index into its nodes
};

// From one value for each of the model's features: the score is base plus the leaf that each tree
// leads to, added in the order of the trees. A value that is not a number goes right.
Prediction predict(const TreeModel& model, std::span<const float> features);
double score(const TreeModel& model, std::span<const float> features);

// How much two candidates are alike to the model that judged both: the part of its trees that lead
// both to the same leaf (the proximity of Breiman's random forests), 0 .. 1; 0 without trees.
double likeness(const Prediction& a, const Prediction& b);

// Throws InputError that names the field ("trees[3].left[5]") unless every tree has a node, every
// inner node's feature is one of the model's, its children stand behind it in the list, and all
// numbers are finite. Then score() ends for any values.
void check(const TreeModel& model);

// Throws InputError unless the model can order candidates of this hand: it is made for the features
// that this version computes (grasp_features.h), and trained on the hand, or for any hand.
void require_fit(const TreeModel& model, const std::string& hand);

// A number that differs, most probably, between models that are not the same: FNV-1a of all their
// content but the name.
std::uint64_t checksum(const TreeModel& model);

}  // namespace prehend
