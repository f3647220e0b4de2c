#include "planner/plan/learn/tree_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

#include "planner/plan/learn/grasp_features.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"

namespace prehend {
namespace {

void check_tree(const Tree& tree, std::size_t features) {
  const auto refuse = [](const char* field, std::size_t node, const char* problem, int value) {
    throw InputError({.field = std::string(field) + "[" + std::to_string(node) + "]",
                      .problem = problem,
                      .value = std::to_string(value)});
  };
  const int count = static_cast<int>(tree.size());
  if (tree.empty()) throw InputError("needs a node");
  for (std::size_t n = 0; n < tree.size(); ++n) {
    const TreeNode& node = tree[n];
    if (!std::isfinite(node.threshold) || !std::isfinite(node.value)) {
      refuse("value", n, "must be finite", node.feature);
    }
    if (node.feature == -1) continue;
    if (node.feature < 0 || index(node.feature) >= features) {
      refuse("feature", n, "is none of the features", node.feature);
    }
    const auto is_behind = [&](int child) { return child > static_cast<int>(n) && child < count; };
    if (!is_behind(node.left)) refuse("left", n, "must be a node behind its parent", node.left);
    if (!is_behind(node.right)) refuse("right", n, "must be a node behind its parent", node.right);
  }
}

// Fowler, Noll and Vo, 64 bits.
class Fnv {
 public:
  void add(std::uint64_t value) {
    for (int byte = 0; byte < 8; ++byte) {
      sum_ = (sum_ ^ ((value >> (8 * byte)) & 0xffU)) * 0x100000001b3U;
    }
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(int value) { add(static_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    for (const char c : text) add(static_cast<int>(c));
    add(static_cast<int>(text.size()));
  }
  std::uint64_t sum() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325U;
};

}  // namespace

Prediction predict(const TreeModel& model, std::span<const float> features) {
  Prediction prediction;
  prediction.score = model.base;
  prediction.leaves.reserve(model.trees.size());
  for (const Tree& tree : model.trees) {
    std::size_t n = 0;
    while (tree[n].feature >= 0) {
      const TreeNode& node = tree[n];
      n = index(features[index(node.feature)] < node.threshold ? node.left : node.right);
    }
    prediction.score += tree[n].value;
    prediction.leaves.push_back(static_cast<int>(n));
  }
  return prediction;
}

double score(const TreeModel& model, std::span<const float> features) {
  return predict(model, features).score;
}

double likeness(const Prediction& a, const Prediction& b) {
  if (a.leaves.empty()) return 0.0;
  std::size_t same = 0;
  for (std::size_t t = 0; t < a.leaves.size(); ++t) same += a.leaves[t] == b.leaves[t] ? 1 : 0;
  return static_cast<double>(same) / static_cast<double>(a.leaves.size());
}

void check(const TreeModel& model) {
  require(std::isfinite(model.base), {.field = "base", .problem = "must be finite"});
  for (std::size_t t = 0; t < model.trees.size(); ++t) {
    try {
      check_tree(model.trees[t], model.features.size());
    } catch (const InputError& error) {
      throw error.under("trees[" + std::to_string(t) + "]");
    }
  }
}

void require_fit(const TreeModel& model, const std::string& hand) {
  if (model.features_version != kGraspFeaturesVersion) {
    throw InputError({.field = "features_version",
                      .problem = "is a model of other features than version " +
                                 std::to_string(kGraspFeaturesVersion),
                      .value = std::to_string(model.features_version)});
  }
  if (model.features != grasp_feature_names()) {
    throw InputError({.field = "features", .problem = "are not the features of this version"});
  }
  if (model.any_hand || std::count(model.hands.begin(), model.hands.end(), hand) > 0) return;
  const std::string known = joined(model.hands);
  throw InputError({.field = "hands",
                    .problem = "was trained for other hands (" + known + "), not for any",
                    .value = hand});
}

std::uint64_t checksum(const TreeModel& model) {
  Fnv fnv;
  fnv.add(model.features_version);
  for (const std::string& name : model.features) fnv.add(std::string_view(name));
  for (const std::string& name : model.hands) fnv.add(std::string_view(name));
  fnv.add(static_cast<int>(model.any_hand));
  fnv.add(model.objects);
  fnv.add(model.trials);
  fnv.add(model.base);
  for (const Tree& tree : model.trees) {
    fnv.add(static_cast<int>(tree.size()));
    for (const TreeNode& node : tree) {
      fnv.add(node.feature);
      fnv.add(static_cast<double>(node.threshold));
      fnv.add(node.left);
      fnv.add(node.right);
      fnv.add(static_cast<double>(node.value));
    }
  }
  return fnv.sum();
}

}  // namespace prehend
