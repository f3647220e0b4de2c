#include "planner/results/datasets/graspgen_file.h"

#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "planner/results/datasets/grasp_set_checks.h"
#include "planner/results/datasets/pose_matrix.h"
#include "sim/base/json/json_field.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

std::string one_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json matrix_json(const Pose& pose) {
  Json rows = Json::array();
  for (Eigen::Index row = 0; row < 4; ++row) {
    Json numbers = Json::array();
    for (Eigen::Index column = 0; column < 4; ++column) {
      numbers.push_back(pose.matrix()(row, column));
    }
    rows.push_back(std::move(numbers));
  }
  return rows;
}

Pose read_matrix(const JsonField& field) {
  std::vector<double> values;
  for (const JsonField& row : field.items()) {
    const std::vector<double> numbers = row.numbers(4);
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  if (values.size() != kMatrixSize) field.fail("must be a matrix of 4 rows");
  const auto pose = pose_of_matrix(std::span<const double, kMatrixSize>(values));
  if (!pose) field.fail("must be a rigid transform");
  return *pose;
}

// Other programs write masks as true and false, as numbers, or as a column.
bool read_label(const JsonField& field) {
  if (field.is_list()) {
    const std::vector<JsonField> items = field.items();
    if (items.size() != 1 || items.front().is_list()) field.fail("must be true or false");
    return read_label(items.front());
  }
  if (field.json() == "true" || field.json() == "false") return field.boolean();
  const double number = field.number();
  if (number != 0.0 && number != 1.0) field.fail("must be 0 or 1");
  return number == 1.0;
}

GraspSetObject read_scaled_object(const JsonField& field) {
  GraspSetObject object;
  if (field.has("file")) object.file = field["file"].text();
  object.scale = field["scale"].number();
  if (!(object.scale > 0.0)) field["scale"].fail("must be above 0");
  return object;
}

}  // namespace

// A grasp a line; as one JSON value all of them would take many times the memory of their text.
std::string graspgen_text(const GraspSet& set) {
  require_sound(set);
  Json object;
  if (!set.object.file.empty()) object["file"] = set.object.file;
  object["scale"] = set.object.scale;
  std::string text = "{\"object\": " + one_line(object) + ",\n\"grasps\": {\"transforms\": [";
  std::string labels;
  for (const GraspSetEntry& grasp : set.grasps) {
    const bool first = &grasp == set.grasps.data();
    text += (first ? "\n" : ",\n") + one_line(matrix_json(grasp.X_OH));
    labels += (first ? "" : ", ");
    labels += grasp.outcome == Outcome::stable ? "true" : "false";
  }
  return text + "],\n\"object_in_gripper\": [" + labels + "]}}\n";
}

bool is_graspgen(const JsonFile& file) {
  const JsonField root = file.root();
  return root.is_object() && root.has("grasps") && root["grasps"].is_object() &&
         root["grasps"].has("transforms");
}

GraspSet read_graspgen(const JsonFile& file) {
  GraspSet set;
  set.object = read_scaled_object(file.root()["object"]);
  const JsonField grasps = file.root()["grasps"];
  for (const JsonField& field : grasps["transforms"].items()) {
    GraspSetEntry& grasp = set.grasps.emplace_back();
    grasp.X_OH_aim = grasp.X_OH = read_matrix(field);
  }
  const std::vector<JsonField> labels = grasps["object_in_gripper"].items();
  if (labels.size() != set.grasps.size()) {
    grasps["object_in_gripper"].fail("must be as many as transforms");
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    set.grasps[i].outcome = read_label(labels[i]) ? Outcome::stable : Outcome::not_force_closure;
  }
  return set;
}

}  // namespace prehend
