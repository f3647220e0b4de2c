#include "planner/plan/learn/tree_model_file.h"

#include <cmath>
#include <limits>
#include <vector>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"

namespace prehend {
namespace {

float read_float(const JsonField& field) {
  const double value = field.number();
  if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) {
    field.fail("is too large for a model");
  }
  return static_cast<float>(value);
}

std::vector<std::string> read_names(const JsonField& field) {
  std::vector<std::string> names;
  for (const JsonField& item : field.items()) names.push_back(item.text());
  return names;
}

int read_count(const JsonField& field) {
  const int count = field.integer();
  if (count < 0) field.fail("must not be negative");
  return count;
}

// Lists with an entry for each node.
Tree read_tree(const JsonField& field) {
  field.allow_only({"feature", "threshold", "left", "right", "value"});
  const std::vector<JsonField> features = field["feature"].items();
  const std::size_t count = features.size();
  const auto items = [&](const char* name) {
    std::vector<JsonField> list = field[name].items();
    if (list.size() != count) field[name].fail("must be as long as feature");
    return list;
  };
  const std::vector<JsonField> thresholds = items("threshold");
  const std::vector<JsonField> left = items("left");
  const std::vector<JsonField> right = items("right");
  const std::vector<JsonField> values = items("value");
  Tree tree;
  for (std::size_t n = 0; n < count; ++n) {
    tree.push_back({features[n].integer(), read_float(thresholds[n]), left[n].integer(),
                    right[n].integer(), read_float(values[n])});
  }
  return tree;
}

TreeModel read_model(const JsonFile& file) {
  const JsonField root = file.root();
  root.allow_only({"format", "features_version", "features", "hands", "any_hand", "objects",
                   "trials", "base", "trees"});
  if (root["format"].text() != kTreeModelFormat) {
    root["format"].fail(std::string("must be \"") + kTreeModelFormat + "\"");
  }
  TreeModel model;
  model.name = file.path().stem().string();
  model.features_version = root["features_version"].integer();
  model.features = read_names(root["features"]);
  model.hands = read_names(root["hands"]);
  model.any_hand = root["any_hand"].boolean();
  model.objects = read_count(root["objects"]);
  model.trials = read_count(root["trials"]);
  model.base = root["base"].number();
  for (const JsonField& tree : root["trees"].items()) model.trees.push_back(read_tree(tree));
  try {
    check(model);
  } catch (const InputError& error) {
    throw error.in_file(file.path().string());
  }
  return model;
}

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// "[a,b,c]" of the texts that `text` makes of the values.
template <typename Values, typename Text>
std::string list_of(const Values& values, const Text& text) {
  std::string list;
  for (const auto& value : values) list += (list.empty() ? "" : ",") + text(value);
  return "[" + list + "]";
}

// Nine digits tell all numbers of single precision apart.
std::string float_text(float value) { return formatted("%.9g", static_cast<double>(value)); }

std::string tree_json(const Tree& tree) {
  const auto node_list = [&](const auto& text) { return list_of(tree, text); };
  return "{\"feature\":" +
         node_list([](const TreeNode& node) { return std::to_string(node.feature); }) +
         ",\"threshold\":" +
         node_list([](const TreeNode& node) { return float_text(node.threshold); }) +
         ",\"left\":" + node_list([](const TreeNode& node) { return std::to_string(node.left); }) +
         ",\"right\":" +
         node_list([](const TreeNode& node) { return std::to_string(node.right); }) +
         ",\"value\":" + node_list([](const TreeNode& node) { return float_text(node.value); }) +
         "}";
}

}  // namespace

TreeModel read_tree_model(const std::filesystem::path& file) { return read_model(JsonFile(file)); }

TreeModel parse_tree_model(const std::filesystem::path& file, const std::string& text) {
  return read_model(JsonFile(file, text));
}

std::string tree_model_json(const TreeModel& model) {
  std::string text = "{\n\"format\":" + quoted(kTreeModelFormat);
  text += ",\n\"features_version\":" + std::to_string(model.features_version);
  text += ",\n\"features\":" + list_of(model.features, quoted);
  text += ",\n\"hands\":" + list_of(model.hands, quoted);
  text += std::string(",\n\"any_hand\":") + (model.any_hand ? "true" : "false");
  text += ",\n\"objects\":" + std::to_string(model.objects);
  text += ",\n\"trials\":" + std::to_string(model.trials);
  text += ",\n\"base\":" + formatted("%.17g", model.base) + ",\n\"trees\":[";
  for (std::size_t t = 0; t < model.trees.size(); ++t) {
    text += (t == 0 ? "\n" : ",\n") + tree_json(model.trees[t]);
  }
  return text + "\n]\n}\n";
}

}  // namespace prehend
