#include "planner/live/scene_edits.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/base/input_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/named_mass.h"
#include "sim/scene/object_friction.h"
#include "sim/scene/object_mass.h"
#include "sim/scene/object_mesh.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_library.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mesh_repair.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

// Formats of text in which a mesh is all in one file: glTF refers to others, which a client could
// not send.
constexpr std::array<std::string_view, 7> kTextFormats = {"obj", "stl", "ply", "off",
                                                          "dae", "iv",  "wrl"};

bool is_library_scene(const std::string& name) {
  const std::vector<std::string> names = library_scene_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

void require_one_source(const SurfaceOrder& order) {
  int given = 0;
  for (const std::string* source : {&order.scene, &order.generate, &order.mesh, &order.mesh_text}) {
    if (!source->empty()) ++given;
  }
  require(given == 1, {.problem = "needs exactly one of scene, generate, mesh and mesh_text"});
}

// What a function says of a value, as an error of the field that gave it.
template <typename Make>
auto asked_by(const std::string& field, const std::string& value, const Make& make) {
  try {
    return make();
  } catch (const InputError& error) {
    throw error.about(field, value);
  }
}

BodySurface surface_of_library(const std::string& name) {
  require(is_library_scene(name),
          {.field = "scene", .problem = "no scene of the library", .value = name});
  Scene scene = load_scene(name);
  return {std::move(scene.object.mesh), scene.object.source, scene.object.name};
}

BodySurface surface_of_file(const SurfaceOrder& order, const OpenFolders& folders) {
  const std::filesystem::path file = folders.path_of(order.mesh, "mesh");
  ObjectMesh read = asked_by("mesh", order.mesh, [&] {
    return load_object_mesh(file, {order.unit, true});
  });
  return {std::move(read.mesh), MeshFileSource{file.string(), read.unit, true},
          file.stem().string(), std::move(read.parts)};
}

// The text is no file of anybody's, so that a scene file will have to list the triangles. They are
// kept as the list that a scene file is read with, so that it is written with the same bytes again.
WrittenShapesSource written(const TriangleMesh& mesh) {
  nlohmann::json shape{{"shape", "triangles"}};
  for (const Vector3& v : mesh.vertices) shape["vertices"].push_back({v.x(), v.y(), v.z()});
  for (const Triangle& t : mesh.triangles) shape["triangles"].push_back(t);
  return {nlohmann::json::array({shape}).dump()};
}

BodySurface surface_of_text(const SurfaceOrder& order) {
  const bool known =
      std::find(kTextFormats.begin(), kTextFormats.end(), order.format) != kTextFormats.end();
  require(known, {.field = "format",
                  .problem = "beside mesh_text, must be one of obj, stl, ply, off, dae, iv, wrl",
                  .value = order.format});
  return asked_by("mesh_text", "", [&] {
    const std::filesystem::path file("given." + order.format);
    const double given = order.unit.empty() ? 1.0 : metres_per_unit(order.unit);
    LoadedMesh read = read_mesh(order.mesh_text, file, {.metres_per_unit = given});
    if (order.unit.empty() && !states_unit(file)) {
      const std::string unit =
          likely_unit(bounds(read.mesh).size().maxCoeff(), order.format == "stl");
      read = read_mesh(order.mesh_text, file, {.metres_per_unit = metres_per_unit(unit)});
    }
    TriangleMesh mesh = repair_mesh(read.mesh).mesh;
    WrittenShapesSource source = written(mesh);
    return BodySurface{std::move(mesh), std::move(source), "object"};
  });
}

std::vector<StaticBody>::iterator find_obstacle(Scene& scene, const std::string& name) {
  const auto found = std::find_if(scene.obstacles.begin(), scene.obstacles.end(),
                                  [&](const StaticBody& body) { return body.name == name; });
  require(found != scene.obstacles.end(),
          {.field = "name", .problem = "no obstacle has this name", .value = name});
  return found;
}

void require_free_name(const Scene& scene, const std::string& name, const std::string& field) {
  const bool used = std::any_of(scene.obstacles.begin(), scene.obstacles.end(),
                                [&](const StaticBody& body) { return body.name == name; });
  require(!used, {.field = field, .problem = "another obstacle has this name", .value = name});
}

void require_mass(double mass) {
  require(mass > 0.0 && mass <= 1e9, {.field = "mass",
                                      .problem = "must be above 0 and at most 1e9 kg",
                                      .value = std::to_string(mass)});
}

}  // namespace

BodySurface surface_of(const SurfaceOrder& order, const OpenFolders& folders) {
  require_one_source(order);
  if (!order.scene.empty()) return surface_of_library(order.scene);
  if (!order.mesh.empty()) return surface_of_file(order, folders);
  if (!order.mesh_text.empty()) return surface_of_text(order);
  TriangleMesh mesh = asked_by("generate", order.generate,
                               [&] { return generate_object(order.generate, order.triangles); });
  return {std::move(mesh), GeneratedSource{order.generate, order.triangles}, order.generate};
}

Scene scene_of_hand(const std::string& hand) {
  Scene scene;
  scene.name = "scene";
  choose_hand(scene, hand);
  return scene;
}

Scene open_scene(const std::string& name_or_file, const OpenFolders& folders) {
  if (is_library_scene(name_or_file)) return load_scene(name_or_file);
  const std::filesystem::path file = folders.path_of(name_or_file, "scene");
  return asked_by("scene", name_or_file, [&] {
    if (file.extension() != ".json") return load_scene(file);
    const JsonFile json(file);
    folders.check_scene(json.root());
    return read_scene(json);
  });
}

Scene scene_of_text(const std::string& text, const OpenFolders& folders) {
  return asked_by("text", "", [&] {
    const JsonFile json("scene", text);
    folders.check_scene(json.root());
    return read_scene(json);
  });
}

void set_object(Scene& scene, BodySurface surface, const BodyOrder& order) {
  if (order.mass) require_mass(*order.mass);
  const std::string name = order.name.empty() ? surface.name : order.name;
  GraspableBody object =
      make_graspable(name, std::move(surface.mesh), order.material.value_or(Material::plastic),
                     order.mass.value_or(kDefaultObjectMass));
  object.source = std::move(surface.source);
  if (order.X_WB) object.X_WO = *order.X_WB;
  scene.object = std::move(object);
  forget_surface(scene);
  scene.notes.clear();
  spread_named_mass(scene.object, surface.parts, order.mass, scene.notes);
  note_uniform_mass(scene);
}

void change_object(Scene& scene, const BodyOrder& order) {
  GraspableBody& object = scene.object;
  require(!object.mesh.empty(), {.field = "object", .problem = "there is none"});
  if (order.mass) {
    require_mass(*order.mass);
    state_mass(object, {.mass = *order.mass});
    object.mass_basis = MassBasis::uniform;
    object.stated_mass.reset();
  }
  if (!order.name.empty()) object.name = order.name;
  if (order.material) object.material = *order.material;
  if (order.X_WB) object.X_WO = *order.X_WB;
}

void remove_object(Scene& scene) {
  require(!scene.object.mesh.empty(), {.field = "object", .problem = "there is none"});
  scene.object = {};
  forget_surface(scene);
  scene.notes.clear();
}

void add_obstacle(Scene& scene, BodySurface surface, const BodyOrder& order) {
  const std::string name = order.name.empty() ? surface.name : order.name;
  require_free_name(scene, name, "name");
  add_obstacle(scene, name, std::move(surface.mesh), order.X_WB.value_or(Pose::Identity()),
               order.material.value_or(Material::wood));
  scene.obstacles.back().source = std::move(surface.source);
}

void change_obstacle(Scene& scene, const std::string& name, const BodyOrder& order) {
  StaticBody& body = *find_obstacle(scene, name);
  if (!order.name.empty() && order.name != name) require_free_name(scene, order.name, "to");
  if (!order.name.empty()) body.name = order.name;
  if (order.material) body.material = *order.material;
  if (order.X_WB) body.X_WB = *order.X_WB;
}

void remove_obstacle(Scene& scene, const std::string& name) {
  scene.obstacles.erase(find_obstacle(scene, name));
}

void change_friction(Scene& scene, std::optional<Material> material, double friction) {
  require(!scene.object.mesh.empty(), {.field = "object", .problem = "there is none"});
  if (material) {
    set_static_friction(scene, scene.object.material, *material, friction);
  } else {
    set_object_friction(scene, friction);
  }
}

void choose_hand(Scene& scene, const std::string& hand) {
  scene.hand = asked_by("hand", hand, [&] { return with_hand(find_robot(hand)); });
  scene.hand_source = robot_source(hand);
  scene.carrier.reset();
  scene.link_surfaces.clear();
}

}  // namespace prehend
