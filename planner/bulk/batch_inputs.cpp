#include "planner/bulk/batch_inputs.h"

#include <utility>

#include "planner/bulk/content_key.h"
#include "planner/plan/learn/tree_model.h"
#include "planner/plan/search_settings.h"
#include "planner/results/json_settings.h"
#include "sim/robot/files/robot_text.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"

namespace prehend {
namespace {

// Stands for the object of a scene until a part brings its own.
GraspableBody placeholder() {
  TriangleMesh tetrahedron;
  tetrahedron.vertices = {{0.0, 0.0, 0.0}, {0.05, 0.0, 0.0}, {0.0, 0.05, 0.0}, {0.0, 0.0, 0.05}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return make_graspable("object", std::move(tetrahedron), Material::plastic);
}

// What the scene says, with every body by its triangles instead of the name of its file: the same
// name for the same content, wherever it lies. The object of a scene says where others are placed.
std::string scene_key(const Scene& scene) {
  Scene written = scene;
  written.object.source = std::monostate{};
  for (StaticBody& body : written.obstacles) body.source = std::monostate{};
  ContentKey key;
  key.add(robot_text(scene.hand));
  if (scene.carrier) {
    for (const RobotTextFile& file : platform_text(scene.carrier->platform, "platform.json")) {
      key.add(file.content);
    }
  }
  key.add(scene_text(written));
  return key.name();
}

Scene scene_with(const BatchScene& named, const std::string& hand) {
  if (named.scene.empty()) return make_scene(placeholder(), hand);
  SceneSource source;
  source.hand = hand;
  return load_scene(named.scene, source);
}

// A model that orders candidates has to be one for each of the hands.
void require_fitting_model(const BatchSetting& setting, const std::vector<SceneTemplate>& scenes) {
  if (!setting.options.search.learned) return;
  for (const SceneTemplate& scene : scenes) {
    try {
      require_fit(*setting.options.search.learned->model, scene.scene.hand.name);
    } catch (const InputError& error) {
      throw error.under("settings \"" + setting.name + "\"");
    }
  }
}

}  // namespace

BatchInputs::BatchInputs(const Batch& batch)
    : hand_count_(batch.hands.size()), seed_count_(batch.seeds.size()) {
  for (const BatchScene& named : batch.scenes) {
    for (const std::string& hand : batch.hands) {
      Scene scene = scene_with(named, hand);
      std::string key = scene_key(scene);
      scenes_.push_back({std::move(scene), std::move(key)});
    }
  }
  for (const BatchSetting& setting : batch.settings) {
    require_fitting_model(setting, scenes_);
    for (const std::uint64_t seed : batch.seeds) {
      RunRecord record;
      record.options = setting.options;
      record.options.seed = seed;
      settings_.push_back(settings_to_json(record).dump());
      options_.push_back(search_settings(record.options));
    }
  }
}

std::string part_key(const Batch& batch, const BatchInputs& inputs, const BatchPart& part,
                     const std::string& object_key) {
  // Raised when the same inputs lead to other results than before.
  constexpr std::uint64_t kResultVersion = 1;
  ContentKey key;
  key.add(kResultVersion).add(std::string_view(PREHEND_VERSION)).add(object_key);
  const BatchObject& object = batch.objects[part.object];
  key.add(object.name).add(object.file);
  if (const auto* file = std::get_if<MeshFileSource>(&object.source)) {
    key.add(file->unit).add(static_cast<std::uint64_t>(file->repair));
  }
  key.add(batch.scales[part.scale]).add(name_of(batch.material));
  key.add(batch.density.value_or(0.0)).add(batch.frictions[part.friction].value_or(-1.0));
  key.add(inputs.scene_of(part).key).add(inputs.settings_of(part));
  return key.name();
}

}  // namespace prehend
