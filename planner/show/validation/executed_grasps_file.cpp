#include "planner/show/validation/executed_grasps_file.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "planner/results/json_posture.h"
#include "planner/show/validation/open_hand.h"
#include "sim/base/index.h"
#include "sim/base/input_file.h"
#include "sim/base/json/json_fields.h"
#include "sim/scene/scene_file.h"

namespace prehend {
namespace {

constexpr const char* kFormat = "prehend truth 1";

// A mass that no hand lifts is a mistake of the unit [kg].
constexpr double kHeaviest = 1000.0;

// The file of a scene or mesh. As in grasp files, a path that is relative to the file is preferred
// to one that is relative to the working directory, and to a library scene of that name.
std::filesystem::path scene_of(const JsonField& object) {
  const std::string name = object["scene"].text();
  const std::filesystem::path beside = object.file().parent_path() / name;
  return is_there(beside) ? beside : std::filesystem::path(name);
}

void set_mass(const JsonField& field, GraspableBody& object) {
  const double mass = field.number();
  if (!(mass > 0.0 && mass <= kHeaviest)) field.fail("must be above 0 and at most 1000 kg");
  object.inertia *= mass / object.mass;
  object.mass = mass;
}

ExecutedObject read_object(const JsonField& field, const std::string& hand,
                           const RunContext& context) {
  field.allow_only({"name", "scene", "hand", "unit", "mass"});
  SceneSource source;
  source.hand = field.text_or("hand", hand);
  source.unit = field.text_or("unit", "");
  const std::string name = field["name"].text();
  return with_field_errors(field["scene"], [&] {
    Scene scene = load_scene(scene_of(field), source);
    if (field.has("mass")) set_mass(field["mass"], scene.object);
    return ExecutedObject{name, compile(std::move(scene), context)};
  });
}

// The hand's posture when it begins to close: by default that of its widest preshape.
void read_posture(const JsonField& field, const Robot& hand, Candidate& grasp) {
  const std::vector<Preshape>& preshapes = hand.hand->preshapes;
  if (field.has("preshape")) {
    const std::string name = field["preshape"].text();
    const auto found = std::find_if(preshapes.begin(), preshapes.end(),
                                    [&](const Preshape& p) { return p.name == name; });
    if (found == preshapes.end()) field["preshape"].fail("no preshape of hand " + hand.name);
    grasp.preshape = static_cast<int>(found - preshapes.begin());
  } else if (field.has("dofs")) {
    grasp.dofs = read_dofs(field["dofs"], hand);
  } else {
    grasp.preshape = static_cast<int>(&widest_preshape(*hand.hand) - preshapes.data());
  }
}

void read_approach(const JsonField& field, Candidate& grasp) {
  field.allow_only({"direction", "distance"});
  if (field.has("direction")) grasp.approach_O = field["direction"].direction();
  if (!field.has("distance")) return;
  grasp.approach_distance = field["distance"].number();
  if (grasp.approach_distance < 0.0) field["distance"].fail("must not be negative");
}

Candidate read_grasp_of(const JsonField& field, const Scene& scene) {
  Candidate grasp;
  if (field.has("X_object_hand")) {
    grasp.X_OH = read_pose(field["X_object_hand"]);
  } else if (field.has("X_world_hand")) {
    grasp.X_OH = scene.object.X_WO.inverse() * read_pose(field["X_world_hand"]);
  } else {
    field.fail("needs X_object_hand");
  }
  grasp.approach_O = grasp.X_OH.linear() * scene.hand.hand->approach;
  read_posture(field, scene.hand, grasp);
  if (field.has("approach")) read_approach(field["approach"], grasp);
  return grasp;
}

int place_of(const std::string& name, std::vector<std::string>& names) {
  const auto found = std::find(names.begin(), names.end(), name);
  const auto place = static_cast<int>(found - names.begin());
  if (found == names.end()) names.push_back(name);
  return place;
}

int object_of(const JsonField& field, const std::vector<ExecutedObject>& objects) {
  const std::string name = field.text();
  const auto found =
      std::find_if(objects.begin(), objects.end(),
                   [&](const ExecutedObject& object) { return object.name == name; });
  if (found == objects.end()) field.fail("is none of the file's objects");
  return static_cast<int>(found - objects.begin());
}

Execution read_execution(const JsonField& field, ExecutedGrasps& truth) {
  field.allow_only({"object", "session", "X_object_hand", "X_world_hand", "preshape", "dofs",
                    "approach", "lifted", "times"});
  Execution execution;
  Label& label = execution.label;
  label.object = object_of(field["object"], truth.objects);
  label.session = place_of(field.text_or("session", "-"), truth.sessions);
  label.lifted = field["lifted"].boolean();
  if (field.has("times")) label.times = field["times"].integer();
  if (label.times < 1 || label.times > 1000000) field["times"].fail("must be from 1 to 1000000");
  execution.grasp = read_grasp_of(field, truth.objects[index(label.object)].scene.scene);
  return execution;
}

void require_both_outcomes(const JsonField& executions, const ExecutedGrasps& truth) {
  const auto lifted =
      std::count_if(truth.executions.begin(), truth.executions.end(),
                    [](const Execution& execution) { return execution.label.lifted; });
  const auto all = static_cast<std::ptrdiff_t>(truth.executions.size());
  if (all == 0) executions.fail("must not be empty");
  if (lifted > 0 && lifted < all) return;
  throw InputError({executions.file().string(), executions.name(),
                    lifted == 0 ? "none of them lifted, nothing can be compared"
                                : "none of them failed, nothing can be compared",
                    "lifted " + std::to_string(lifted) + " of " + std::to_string(all)});
}

std::vector<ExecutedObject> read_objects(const JsonField& root, const RunContext& context) {
  const std::string hand = root.text_or("hand", "");
  std::vector<ExecutedObject> objects;
  for (const JsonField& field : root["objects"].items()) {
    context.cancellation.check();
    ExecutedObject object = read_object(field, hand, context);
    const bool known =
        std::any_of(objects.begin(), objects.end(),
                    [&](const ExecutedObject& other) { return other.name == object.name; });
    if (known) field["name"].fail("is there twice");
    objects.push_back(std::move(object));
  }
  return objects;
}

void check_root(const JsonField& root) {
  root.allow_only({"format", "hand", "objects", "executions"});
  if (root["format"].text() == kFormat) return;
  root["format"].fail("must be \"" + std::string(kFormat) + "\"");
}

}  // namespace

std::vector<Label> ExecutedGrasps::labels() const {
  std::vector<Label> labels;
  for (const Execution& execution : executions) labels.push_back(execution.label);
  return labels;
}

ExecutedGrasps read_executed_grasps(const JsonFile& file, const RunContext& context) {
  check_root(file.root());
  return read_executions(file, read_objects(file.root(), context));
}

ExecutedGrasps read_executions(const JsonFile& file, std::vector<ExecutedObject> objects) {
  const JsonField root = file.root();
  check_root(root);
  ExecutedGrasps truth;
  truth.objects = std::move(objects);
  for (const JsonField& field : root["executions"].items()) {
    truth.executions.push_back(read_execution(field, truth));
  }
  require_both_outcomes(root["executions"], truth);
  return truth;
}

}  // namespace prehend
