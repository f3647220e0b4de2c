#include <limits>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <xgboost/c_api.h>

#include <nlohmann/json.hpp>

#include "planner/bulk/train/boost_trees.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"

namespace prehend {
namespace {

void require_done(int status) {
  if (status == 0) return;
  const std::string why = XGBGetLastError();
  if (why.find("bad_alloc") != std::string::npos) throw std::bad_alloc();
  throw std::runtime_error("xgboost: " + why);
}

struct FreeMatrix {
  void operator()(void* handle) const { (void)XGDMatrixFree(handle); }
};
struct FreeBooster {
  void operator()(void* handle) const { (void)XGBoosterFree(handle); }
};
using Matrix = std::unique_ptr<void, FreeMatrix>;
using Booster = std::unique_ptr<void, FreeBooster>;

Matrix matrix_of(const BoostRows& rows) {
  const std::size_t count = rows.labels.size();
  require(count > 0, {.field = "rows", .problem = "there are none"});
  DMatrixHandle handle = nullptr;
  require_done(XGDMatrixCreateFromMat(rows.values.data(), count, rows.features,
                                      std::numeric_limits<float>::quiet_NaN(), &handle));
  Matrix matrix(handle);
  require_done(XGDMatrixSetFloatInfo(handle, "label", rows.labels.data(), count));
  if (!rows.groups.empty()) {
    require_done(XGDMatrixSetUIntInfo(handle, "group", rows.groups.data(), rows.groups.size()));
  }
  return matrix;
}

Booster grown(DMatrixHandle matrix, const BoostOptions& options) {
  BoosterHandle handle = nullptr;
  require_done(XGBoosterCreate(&matrix, 1, &handle));
  Booster booster(handle);
  const auto set = [&](const char* name, const std::string& value) {
    require_done(XGBoosterSetParam(handle, name, value.c_str()));
  };
  set("objective", options.goal == BoostGoal::value ? "reg:squarederror" : "rank:pairwise");
  set("tree_method", "hist");
  set("nthread", "1");
  set("verbosity", "0");
  set("seed", std::to_string(options.seed));
  set("base_score", "0");
  set("max_depth", std::to_string(options.depth));
  set("eta", formatted("%.17g", options.learning_rate));
  set("min_child_weight", formatted("%.17g", options.least_weight));
  set("subsample", formatted("%.17g", options.rows_part));
  set("colsample_bytree", formatted("%.17g", options.columns_part));
  for (int i = 0; i < options.trees; ++i) {
    require_done(XGBoosterUpdateOneIter(handle, i, matrix));
  }
  return booster;
}

// xgboost keeps the value of a leaf where inner nodes have their threshold.
Tree tree_of(const nlohmann::json& json) {
  const auto& left = json.at("left_children");
  Tree tree;
  for (std::size_t n = 0; n < left.size(); ++n) {
    const auto condition = json.at("split_conditions").at(n).get<float>();
    TreeNode node;
    if (left.at(n).get<int>() < 0) {
      node.value = condition;
    } else {
      node = {json.at("split_indices").at(n).get<int>(), condition, left.at(n).get<int>(),
              json.at("right_children").at(n).get<int>(), 0.0F};
    }
    tree.push_back(node);
  }
  return tree;
}

}  // namespace

bool can_boost() { return true; }

void require_training() {}

BoostedTrees boost_trees(const BoostRows& rows, const BoostOptions& options) {
  const Matrix matrix = matrix_of(rows);
  const Booster booster = grown(matrix.get(), options);
  bst_ulong length = 0;
  const char* text = nullptr;
  require_done(XGBoosterSaveModelToBuffer(booster.get(), R"({"format": "json"})", &length, &text));
  const nlohmann::json model = nlohmann::json::parse(std::string(text, length)).at("learner");
  BoostedTrees boosted;
  boosted.base = std::stod(model.at("learner_model_param").at("base_score").get<std::string>());
  for (const nlohmann::json& tree : model.at("gradient_booster").at("model").at("trees")) {
    boosted.trees.push_back(tree_of(tree));
  }
  return boosted;
}

std::vector<float> boosted_predictions(const BoostRows& rows, const BoostOptions& options) {
  const Matrix matrix = matrix_of(rows);
  const Booster booster = grown(matrix.get(), options);
  bst_ulong count = 0;
  const float* values = nullptr;
  require_done(XGBoosterPredict(booster.get(), matrix.get(), 0, 0, 0, &count, &values));
  return {values, values + count};
}

}  // namespace prehend
