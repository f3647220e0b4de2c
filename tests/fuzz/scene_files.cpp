#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "sim/base/json/json_field.h"
#include "sim/base/json/yaml_file.h"
#include "sim/base/xml/xml_file.h"
#include "sim/scene/graspit_world.h"
#include "sim/scene/moveit_scene.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_text.h"
#include "tests/fuzz/mesh_promises.h"
#include "tests/fuzz/same_json.h"
#include "tests/fuzz/untrusted_files.h"

namespace prehend::fuzz {
namespace {

void check_object(const GraspableBody& object) {
  check_usable(object.mesh);
  promised(finite(object.X_WO), "the pose of the object is finite");
  promised(object.mass > 0.0 && std::isfinite(object.mass), "the mass is positive");
  promised(object.center_of_mass.allFinite() && object.inertia.allFinite(),
           "the object's inertia is finite");
}

void check_carrier(const Carrier& carrier) {
  promised(finite(carrier.X_WB), "the pose of the platform is finite");
  promised(std::all_of(carrier.start.begin(), carrier.start.end(),
                       [](double value) { return std::isfinite(value); }),
           "the start is finite");
  promised(carrier.start.size() == initial_dofs(carrier.platform).size(),
           "the start has a value for each degree of freedom");
}

void check_scene(const Scene& scene) {
  check_object(scene.object);
  for (const StaticBody& body : scene.obstacles) {
    check_usable(body.mesh);
    promised(finite(body.X_WB), "the pose of an obstacle is finite");
  }
  if (scene.carrier) check_carrier(*scene.carrier);
  promised(scene.hand.hand.has_value() || !scene.carrier, "an arm carries a hand");
  for (const Primitive& primitive : scene.primitives) {
    promised(finite(primitive.X_OP), "the pose of a primitive is finite");
  }
}

// A few bytes may ask for millions of triangles, which is allowed and takes seconds.
bool asks_for_much(const nlohmann::json& value) {
  constexpr double kMuch = 2000.0;
  if (value.is_object() && value.contains("triangles") && value["triangles"].is_number() &&
      value["triangles"].get<double>() > kMuch) {
    return true;
  }
  return value.is_structured() && std::any_of(value.begin(), value.end(), asks_for_much);
}

}  // namespace

// What is written of a scene reads back as the same scene, to rounding.
void read_scene_file(std::string_view name, const std::string& bytes) {
  const std::string path = pretended_path(name, "json");
  const JsonFile file(path, bytes);
  if (asks_for_much(nlohmann::json::parse(bytes))) return;
  const Scene scene = read_scene(file);
  check_scene(scene);
  const std::string text = scene_text(scene);
  promised(same_but_rounded(scene_text(read_scene(JsonFile(path, text))), text),
           "a scene reads back as written");
}

// Of one robot, so that changed bytes do not ask for other files.
void read_moveit_file(std::string_view name, const std::string& bytes) {
  const std::string robot = PREHEND_CORPUS_DIR "/platform/good_arm_with_vice.json";
  const JsonFile file = parse_yaml(pretended_path(name, "yaml"), bytes);
  check_scene(read_moveit_scene(file, {.robot = robot, .needs_object = false}));
}

void read_graspit_world_file(std::string_view name, const std::string& bytes) {
  check_scene(read_graspit_world(XmlFile(pretended_path(name, "xml"), bytes)));
}

}  // namespace prehend::fuzz
