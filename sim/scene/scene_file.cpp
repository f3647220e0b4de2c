#include "sim/scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_field.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/json/yaml_file.h"
#include "sim/base/nearest_name.h"
#include "sim/base/range.h"
#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/robot_file.h"
#include "sim/robot/files/robot_geometry.h"
#include "sim/robot/hand/derive_hand.h"
#include "sim/scene/graspit_world.h"
#include "sim/scene/json_body.h"
#include "sim/scene/json_carrier.h"
#include "sim/scene/json_friction.h"
#include "sim/scene/json_mass.h"
#include "sim/scene/json_primitive.h"
#include "sim/scene/json_region.h"
#include "sim/scene/json_stands_on.h"
#include "sim/scene/json_surface.h"
#include "sim/scene/make_scene.h"
#include "sim/scene/moveit_scene.h"
#include "sim/scene/named_mass.h"
#include "sim/scene/object_friction.h"
#include "sim/scene/object_mass.h"
#include "sim/scene/scene_library.h"
#include "sim/scene/seen_scene.h"
#include "sim/scene/sunk_object.h"

// A scene file is read field by field through JsonField, which knows its place in the file, so that
// every error names the field. Readers of robots, materials and generated objects do not know that
// place: their errors are caught and passed on as errors of the field. Errors in a mesh file name
// the mesh file.
//
// Mesh files and robots are named relative to the scene file; a robot may also be a name of the
// library. The paths are kept as absolute ones, because scene_text may write the scene again to
// another folder.
namespace prehend {
namespace {

namespace fs = std::filesystem;

// Whether the object's mesh file is repaired.
bool read_repair(const JsonField& field, const SceneSource& source) {
  if (!field.has("repair")) return source.repair;
  if (!field.has("mesh")) field["repair"].fail("only of a mesh file");
  return field["repair"].boolean() && source.repair;
}

// What the regions of an object need of its mesh file.
NeededSurfaces needed_surfaces(const Scene& scene, const ObjectChoice& choice) {
  NeededSurfaces needed;
  for (const auto* regions :
       {&scene.keep_out, &scene.preferred, &scene.porous, &choice.keep_out, &choice.preferred}) {
    needed.add(*regions);
  }
  return needed;
}

// Fills in the surfaces of the regions that stand in field `name` of an object.
void find_parts(const JsonField& object, const char* name, const FileSurfaces& file,
                std::vector<SurfaceRegion>& regions) {
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (!regions[i].is_of_file()) continue;
    const JsonField named = object[name].items()[i][regions[i].color ? "color" : "part"];
    with_field_errors(named, [&] { find_file_surface(file, regions[i]); });
  }
}

// The same of all regions of the scene's object, which were read from there.
void find_parts(const JsonField& object, const FileSurfaces& file, Scene& scene) {
  find_parts(object, "keep_out", file, scene.keep_out);
  find_parts(object, "preferred", file, scene.preferred);
  find_parts(object, "porous", file, scene.porous);
}

// Adds regions that were chosen, called `name` in messages.
void add_chosen(const std::vector<SurfaceRegion>& chosen, const FileSurfaces& file,
                const char* name, std::vector<SurfaceRegion>& regions) {
  for (SurfaceRegion region : chosen) {
    try {
      find_file_surface(file, region);
    } catch (const InputError& error) {
      throw error.about(name);
    }
    regions.push_back(std::move(region));
  }
}

void choose_regions(const ObjectChoice& choice, const FileSurfaces& of_file,
                    const std::filesystem::path& file, Scene& scene) {
  try {
    add_chosen(choice.keep_out, of_file, "keep_out", scene.keep_out);
    add_chosen(choice.preferred, of_file, "preferred", scene.preferred);
  } catch (const InputError& error) {
    throw error.in_file(file.string());
  }
}

constexpr const char* kUnnamedObject = "object";

bool says_where_mass_is(const JsonField& field) {
  return field.has("density") || field.has("parts") || field.has("center_of_mass");
}

// The object with its regions, and notes about it.
void read_object(const JsonField& field, const SceneSource& source, const NamedMaterials& named,
                 ShapeBudget& budget, Scene& scene) {
  field.allow_only({"name",     "mesh",      "unit",       "generate", "triangles",
                    "geometry", "material",  "mass",       "density",  "center_of_mass",
                    "parts",    "pose",      "primitives", "repair",   "restitution",
                    "keep_out", "preferred", "porous",     "surfaces", "friction",
                    "stands_on"});
  if (field.has("keep_out")) scene.keep_out = read_regions(field["keep_out"]);
  if (field.has("preferred")) scene.preferred = read_regions(field["preferred"]);
  if (field.has("porous")) scene.porous = read_regions(field["porous"]);
  std::vector<MaterialRegion> surfaces = read_body_surfaces(field, named);
  const bool repair = read_repair(field, source);
  NeededSurfaces needed = needed_surfaces(scene, source.choice);
  needed.add(surfaces);
  ObjectMesh surface = read_object_mesh(field, repair, needed, budget);
  const FileSurfaces of_file{std::move(surface.parts), std::move(surface.colors)};
  find_parts(field, of_file, scene);
  choose_regions(source.choice, of_file, field.file(), scene);
  scene.notes = std::move(surface.notes);
  const std::string name = field.text_or("name", kUnnamedObject);
  const Material material = read_material(field, Material::plastic);
  const double mass = whole_mass(field);
  GraspableBody& body = scene.object;
  body = with_field_errors(
      field, [&] { return make_graspable(name, std::move(surface.mesh), material, mass); });
  read_mass(field, body);
  if (!says_where_mass_is(field)) {
    const std::optional<double> whole = field.has("mass") ? std::optional(mass) : std::nullopt;
    spread_named_mass(body, of_file.parts, whole, scene.notes);
  }
  if (field.has("pose")) body.X_WO = read_pose(field["pose"]);
  body.restitution = read_restitution(field);
  if (field.has("surfaces")) find_surfaces(field["surfaces"], of_file, body.mesh, surfaces);
  body.surfaces = std::move(surfaces);
  body.source = read_source(field);
  if (auto* file = std::get_if<MeshFileSource>(&body.source)) file->repair = repair;
  if (!field.has("primitives")) return;
  for (const JsonField& shape : field["primitives"].items()) {
    scene.primitives.push_back(read_primitive(shape));
  }
}

// Things that no hand holds are noted, whatever unit was stated.
void note_size(Scene& scene) {
  constexpr double kSmallest = 0.002;  // m
  constexpr double kLargest = 1.5;
  const double size = bounds(scene.object.mesh).size().maxCoeff();
  const std::string hint = unit_hint(scene.object);
  if (hint.empty() || (size >= kSmallest && size <= kLargest)) return;
  scene.notes.push_back(
      formatted("%.4g mm large in the stated unit%s", 1000.0 * size, hint.c_str()));
}

// What cameras saw, read when it is first needed: each scene of the same things takes it.
using SeenOnce = std::optional<SeenThings>;

bool is_seen(const JsonField& root) {
  return root.has("object") && root["object"].is_object() && root["object"].has("views");
}

const SeenThings& things_of(const JsonField& object, SeenOnce& seen) {
  if (!seen) {
    const fs::path file = object.file().parent_path() / object["views"].text();
    seen = load_seen_things(file, object.text_or("unit", "m"));
  }
  return *seen;
}

// Says of the obstacles that are objects as well, `names`, how far the hand keeps from them.
void keep_apart(const std::vector<std::string>& names, const ObjectChoice& choice, Scene& scene) {
  require_in(kApart, choice.apart, "apart");
  for (StaticBody& body : scene.obstacles) {
    if (std::find(names.begin(), names.end(), body.name) != names.end()) body.apart = choice.apart;
  }
}

// The thing that is asked for, or that the field states.
std::size_t number_of(const JsonField& object, const std::string& asked, const SeenThings& things) {
  if (!asked.empty() || !object.has("number")) return seen_thing(things, asked);
  const JsonField number = object["number"];
  return with_field_errors(number,
                           [&] { return seen_thing(things, std::to_string(number.integer())); });
}

// The thing as the object, and the others as obstacles.
void read_seen_object(const JsonField& field, const SceneSource& source,
                      const NamedMaterials& named, SeenOnce& seen, Scene& scene) {
  field.allow_only({"views", "unit", "number", "material", "mass", "density", "center_of_mass",
                    "parts", "restitution", "keep_out", "preferred", "porous", "surfaces"});
  const SeenThings& things = things_of(field, seen);
  if (field.has("keep_out")) scene.keep_out = read_regions(field["keep_out"]);
  if (field.has("preferred")) scene.preferred = read_regions(field["preferred"]);
  if (field.has("porous")) scene.porous = read_regions(field["porous"]);
  find_parts(field, {}, scene);
  choose_regions(source.choice, {}, field.file(), scene);
  place_seen(things, number_of(field, source.choice.object, things),
             read_material(field, Material::plastic), whole_mass(field), scene);
  keep_apart(seen_names(things), source.choice, scene);
  read_mass(field, scene.object);
  scene.object.restitution = read_restitution(field);
  scene.object.surfaces = read_body_surfaces(field, named);
  if (!field.has("surfaces")) return;
  find_surfaces(field["surfaces"], {}, scene.object.mesh, scene.object.surfaces);
}

std::vector<std::string> names_of_objects(const JsonField& root) {
  std::vector<std::string> names;
  if (!root.has("objects")) return {root["object"].text_or("name", kUnnamedObject)};
  if (root.has("object")) root["object"].fail("not beside \"objects\"");
  for (const JsonField& field : root["objects"].items()) {
    names.push_back(field["name"].text());
    if (std::count(names.begin(), names.end(), names.back()) > 1) {
      field["name"].fail("must be a name that no other object has");
    }
  }
  if (names.empty()) root["objects"].fail("must have at least one object");
  return names;
}

// An object that is not the one to grasp.
StaticBody in_the_way(const GraspableBody& object) {
  StaticBody body{object.name, object.mesh, object.X_WO, object.material, object.source};
  body.restitution = object.restitution;
  body.surfaces = object.surfaces;
  // The files of obstacles are never repaired.
  if (auto* file = std::get_if<MeshFileSource>(&body.source)) file->repair = true;
  return body;
}

void require_object(const ObjectChoice& choice, const std::vector<std::string>& names,
                    const std::filesystem::path& file) {
  const std::string& asked = choice.object;
  require(asked.empty() || std::find(names.begin(), names.end(), asked) != names.end(),
          {.file = file.string(),
           .field = "object",
           .problem = "the scene has no such object; it has " + joined(names),
           .value = asked});
}

// The chosen object, and all others as obstacles.
void read_objects(const JsonField& root, const SceneSource& source, const NamedMaterials& named,
                  ShapeBudget& budget, SeenOnce& seen, Scene& scene) {
  if (is_seen(root)) {
    if (root.has("objects")) root["object"].fail("not beside \"objects\"");
    read_seen_object(root["object"], source, named, seen, scene);
    note_size(scene);
    note_uniform_mass(scene);
    return;
  }
  const std::vector<std::string> names = names_of_objects(root);
  const std::string& asked = source.choice.object;
  require_object(source.choice, names, root.file());
  const auto chosen = asked.empty() ? names.begin() : std::find(names.begin(), names.end(), asked);
  const auto at = static_cast<std::size_t>(chosen - names.begin());
  const bool several = root.has("objects");
  read_object(several ? root["objects"].items()[at] : root["object"], source, named, budget, scene);
  note_size(scene);
  note_uniform_mass(scene);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i == at) continue;
    SceneSource as_it_is{.hand = "", .repair = source.repair};
    Scene other;
    read_object(root["objects"].items()[i], as_it_is, named, budget, other);
    scene.obstacles.push_back(in_the_way(other.object));
  }
  keep_apart(names, source.choice, scene);
}

// Regions of links, which are those of the hand that the scene names, not of another in its place.
void read_link_surfaces(const JsonField& links, bool other_hand, const NamedMaterials& named,
                        Scene& scene) {
  for (const std::string& name : links.keys()) {
    const JsonField field = links[name];
    LinkSurfaces link{name, read_surfaces(field, named)};
    NeededSurfaces needed;
    needed.add(link.surfaces);
    if (needed.any()) field.fail("a link has no parts with names or colours; state a shape");
    if (other_hand) continue;
    std::vector<std::string> known;
    for (const Link& of_hand : scene.hand.links) {
      known.push_back(of_hand.name);
      if (of_hand.name == name) find_surfaces(field, {}, of_hand.mesh, link.surfaces);
    }
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      field.fail("the hand has no such link; " + did_you_mean(name, known) + "it has " +
                 joined(known));
    }
    scene.link_surfaces.push_back(std::move(link));
  }
  if (other_hand) scene.notes.push_back("link_surfaces are of another hand: not used");
}

Scene read_scene(const JsonField& root, const SceneSource& source, SeenOnce& seen) {
  root.allow_only({"name", "object", "objects", "hand", "robot", "obstacles", "friction",
                   "compliant_depths", "materials", "link_surfaces"});
  if (root.has("hand") && root.has("robot")) {
    root["hand"].fail("not beside \"robot\", whose platform has a hand");
  }
  Scene scene;
  scene.name = root.text_or("name", root.file().stem().string());
  ShapeBudget budget;
  const NamedMaterials named =
      root.has("materials") ? read_materials(root["materials"]) : NamedMaterials();
  if (source.needs_object || root.has("object") || root.has("objects")) {
    read_objects(root, source, named, budget, seen, scene);
  } else {
    scene.object = nothing_to_grasp();
  }
  if (root.has("robot")) {
    if (root["robot"].has("hand")) scene.hand_source = read_robot_source(root["robot"]["hand"]);
    if (!source.hand.empty()) scene.hand_source = robot_source(source.hand);
    scene.carrier = read_carrier(root["robot"], scene.hand_source, source.foreign);
    const Carrier& carrier = *scene.carrier;
    scene.hand = carrier.platform.robots[static_cast<std::size_t>(carrier.hand)].robot;
  } else {
    scene.hand_source = !source.hand.empty() ? robot_source(source.hand)
                        : root.has("hand")   ? read_robot_source(root["hand"])
                                             : kDefaultHand;
    const auto find = [&] { return with_hand(find_robot(scene.hand_source, source.foreign)); };
    const bool asked_here = source.hand.empty() && root.has("hand");
    scene.hand = asked_here ? with_field_errors(root["hand"], find) : find();
  }
  if (root.has("obstacles")) {
    for (const JsonField& field : root["obstacles"].items()) {
      scene.obstacles.push_back(read_obstacle(field, named, budget));
    }
  }
  put_down_all(root, scene);
  raise_sunk_object(scene);
  note_standing_base(scene);
  if (root.has("friction")) read_friction(root["friction"], scene);
  read_object_friction(root, scene);
  if (root.has("compliant_depths"))
    read_compliant_depths(root["compliant_depths"], scene.compliant_depths);
  if (root.has("link_surfaces")) {
    read_link_surfaces(root["link_surfaces"], !source.hand.empty(), named, scene);
  }
  return scene;
}

// What cameras saw, given in place of a scene.
Scene seen_scene(const fs::path& file, const SceneSource& source, const SeenThings& things) {
  Scene scene;
  try {
    scene.name = file.stem().string();
    choose_regions(source.choice, {}, file, scene);
    place_seen(things, seen_thing(things, source.choice.object), Material::plastic,
               kDefaultObjectMass, scene);
    keep_apart(seen_names(things), source.choice, scene);
  } catch (const InputError& error) {
    throw error.in_file(file.string());
  }
  scene.hand_source = robot_source(source.hand.empty() ? kDefaultHand : source.hand);
  scene.hand = with_hand(find_robot(scene.hand_source, source.foreign));
  note_size(scene);
  note_uniform_mass(scene);
  return scene;
}

void require_no_unit(const std::filesystem::path& file, const SceneSource& source) {
  require(source.unit.empty() || source.unit == "m",
          {.file = file.string(),
           .field = "unit",
           .problem = "a scene says the units of its meshes itself",
           .value = source.unit});
}

}  // namespace

Scene read_scene(const JsonFile& file, const SceneSource& source) {
  require_no_unit(file.path(), source);
  SeenOnce seen;
  return read_scene(file.root(), source, seen);
}

namespace {

// Of JSON: a scene, or what cameras saw.
Scene load_json(const JsonFile& file, const SceneSource& source, SeenOnce& seen) {
  require_no_unit(file.path(), source);
  if (!states_views(file.root())) return read_scene(file.root(), source, seen);
  if (!seen) seen = load_seen_things(file.path(), {});
  return seen_scene(file.path(), source, *seen);
}

// Of those scenes, the names of the objects where they may be several.
std::vector<std::string> names_in_json(const JsonFile& file, SeenOnce& seen) {
  const JsonField root = file.root();
  if (states_views(root)) {
    seen = load_seen_things(file.path(), {});
  } else if (is_seen(root)) {
    things_of(root["object"], seen);
  } else {
    return root.has("objects") ? names_of_objects(root) : std::vector<std::string>{};
  }
  return seen_names(*seen);
}

// With the friction as the file says it.
Scene load_as_stated(const fs::path& file, const SceneSource& source) {
  if (has_yaml_name(file)) {
    require_no_unit(file, source);
    Scene scene = read_moveit_scene(read_yaml(file), source);
    choose_regions(source.choice, {}, file, scene);
    if (!source.needs_object) return scene;
    note_size(scene);
    note_uniform_mass(scene);
    raise_sunk_object(scene);
    return scene;
  }
  require(source.robot.empty(), {.file = file.string(),
                                 .field = "robot",
                                 .problem = "only beside a scene of MoveIt; others name theirs",
                                 .value = source.robot});
  if (file.extension() == ".json") {
    SeenOnce seen;
    return load_json(JsonFile(file), source, seen);
  }
  if (is_views_file(file)) {
    return seen_scene(file, source, load_seen_things(file, source.unit));
  }
  if (file.extension() == ".xml") {
    require_no_unit(file, source);
    Scene scene = read_graspit_scene(XmlFile(file), source);
    require_object(source.choice, {scene.object.name}, file);
    choose_regions(source.choice, {}, file, scene);
    note_uniform_mass(scene);
    raise_sunk_object(scene);
    return scene;
  }
  const NeededSurfaces needed = needed_surfaces({}, source.choice);
  ObjectMesh read =
      load_object_mesh(file, {source.unit, source.repair, needed.parts, needed.colors});
  GraspableBody object =
      make_graspable(file.stem().string(), std::move(read.mesh), Material::plastic);
  object.source =
      MeshFileSource{fs::absolute(file).lexically_normal().string(), read.unit, source.repair};
  spread_named_mass(object, read.parts, {}, read.notes);
  require_object(source.choice, {object.name}, file);
  Scene scene = make_scene(std::move(object), source.hand.empty() ? kDefaultHand : source.hand,
                           source.foreign);
  choose_regions(source.choice, {std::move(read.parts), std::move(read.colors)}, file, scene);
  scene.notes = std::move(read.notes);
  // A unit that is the likely one has a note of its own.
  if (!source.unit.empty() || read.unit == "m") note_size(scene);
  note_uniform_mass(scene);
  return scene;
}

void apply_friction(const SceneSource& source, Scene& scene) {
  if (source.friction) set_object_friction(scene, *source.friction);
}

}  // namespace

Scene load_scene(const fs::path& name_or_file, const SceneSource& source) {
  Scene scene = load_as_stated(find_scene(name_or_file.string()), source);
  apply_friction(source, scene);
  return scene;
}

std::vector<Scene> load_each_scene(const fs::path& name_or_file, const SceneSource& source) {
  const fs::path file = find_scene(name_or_file.string());
  std::vector<Scene> scenes;
  SeenOnce seen;
  SceneSource of_object = source;
  const auto load_all = [&](const std::vector<std::string>& names, const auto& load) {
    for (const std::string& name : names) {
      of_object.choice.object = name;
      scenes.push_back(load());
      apply_friction(source, scenes.back());
    }
  };
  if (file.extension() == ".json") {
    const JsonFile json(file);
    load_all(names_in_json(json, seen), [&] { return load_json(json, of_object, seen); });
  } else if (is_views_file(file)) {
    seen = load_seen_things(file, source.unit);
    load_all(seen_names(*seen), [&] { return seen_scene(file, of_object, *seen); });
  } else if (has_yaml_name(file)) {
    const JsonFile yaml = read_yaml(file);
    load_all(moveit_objects(yaml), [&] { return read_moveit_scene(yaml, of_object); });
  }
  return scenes;
}

std::vector<std::string> scene_objects(const fs::path& name_or_file, const std::string& unit) {
  const fs::path file = find_scene(name_or_file.string());
  SeenOnce seen;
  if (file.extension() == ".json") return names_in_json(JsonFile(file), seen);
  if (is_views_file(file)) return seen_names(load_seen_things(file, unit));
  if (has_yaml_name(file)) return moveit_objects(read_yaml(file));
  return {};
}

std::string unit_of_source(const fs::path& name_or_file, const Scene& scene) {
  const std::string itself =
      fs::absolute(find_scene(name_or_file.string())).lexically_normal().string();
  if (const auto* mesh = std::get_if<MeshFileSource>(&scene.object.source)) {
    if (mesh->path == itself) return mesh->unit;
  }
  if (const auto* views = std::get_if<ViewsSource>(&scene.object.source)) {
    if (views->path == itself) return views->unit;
  }
  return "m";
}

}  // namespace prehend
