#include "sim/scene/scene_file.h"

#include <cmath>

#include "sim/geometry/input_error.h"
#include "sim/geometry/mesh_checks.h"
#include "sim/geometry/mesh_file.h"
#include "sim/geometry/object_generator.h"
#include "sim/robot/json_field.h"
#include "sim/robot/robot_file.h"
#include "sim/robot/robot_geometry.h"
#include "sim/scene/json_pose.h"

namespace prehend {
namespace {

Material read_material(const JsonField& body, Material otherwise) {
  if (!body.has("material")) return otherwise;
  const JsonField field = body["material"];
  try {
    return material_named(field.text());
  } catch (const InputError& error) {
    field.fail(error.what());
  }
}

double read_positive(const JsonField& body, const char* key, double otherwise) {
  const double value = body.number_or(key, otherwise);
  if (!(value > 0.0)) body[key].fail("must be positive");
  return value;
}

TriangleMesh mesh_from_file(const std::filesystem::path& file, const std::string& unit) {
  TriangleMesh mesh = load_mesh(file, {.metres_per_unit = metres_per_unit(unit)}).mesh;
  orient_outward(mesh);
  return mesh;
}

// Exactly one of "mesh" (a file beside the scene), "generate" (a name) and "geometry" (shapes).
TriangleMesh read_body_mesh(const JsonField& body) {
  const int given = int{body.has("mesh")} + int{body.has("generate")} + int{body.has("geometry")};
  if (given != 1) body.fail("needs exactly one of mesh, generate, geometry");
  if (body.has("mesh")) {
    const std::filesystem::path file = body.file().parent_path() / body["mesh"].text();
    return mesh_from_file(file, body.text_or("unit", "m"));
  }
  if (body.has("geometry")) return read_geometry(body["geometry"], FileUnits{}, {});
  const int triangles = body.has("triangles") ? body["triangles"].integer() : 5000;
  try {
    return generate_object(body["generate"].text(), triangles);
  } catch (const InputError& error) {
    body.fail(error.what());
  }
}

GraspableBody read_object(const JsonField& field) {
  field.allow_only({"name", "mesh", "unit", "generate", "triangles", "geometry", "material", "mass",
                    "center_of_mass", "pose", "primitives"});
  GraspableBody body = make_graspable(field.text_or("name", "object"), read_body_mesh(field),
                                      read_material(field, Material::plastic),
                                      read_positive(field, "mass", kDefaultObjectMass));
  if (field.has("center_of_mass")) body.center_of_mass = field["center_of_mass"].vector3();
  if (field.has("pose")) body.X_WO = read_pose(field["pose"]);
  return body;
}

StaticBody read_obstacle(const JsonField& field) {
  field.allow_only(
      {"name", "mesh", "unit", "generate", "triangles", "geometry", "material", "pose"});
  StaticBody body{field["name"].text(), read_body_mesh(field), Pose::Identity(),
                  read_material(field, Material::wood)};
  if (field.has("pose")) body.X_WB = read_pose(field["pose"]);
  return body;
}

Shape read_shape(const JsonField& field) {
  const std::string shape = field["shape"].text();
  if (shape == "box") {
    const Box box{field["size"].vector3()};
    if (!(box.size.minCoeff() > 0.0)) field["size"].fail("must be positive");
    return box;
  }
  if (shape == "sphere") return Sphere{read_positive(field, "radius", 0.0)};
  if (shape == "cylinder") {
    return Cylinder{read_positive(field, "radius", 0.0), read_positive(field, "height", 0.0)};
  }
  field["shape"].fail("unknown shape (known: box, sphere, cylinder)");
}

Primitive read_primitive(const JsonField& field) {
  field.allow_only({"shape", "size", "radius", "height", "pose"});
  for (const char* key : {"size", "radius", "height"}) {
    const std::string shape = field["shape"].text();
    const bool belongs = key == std::string("size")     ? shape == "box"
                         : key == std::string("height") ? shape == "cylinder"
                                                        : shape != "box";
    if (belongs) (void)field[key];
    if (!belongs && field.has(key)) field[key].fail("a " + shape + " has no " + key);
  }
  return {read_shape(field), field.has("pose") ? read_pose(field["pose"]) : Pose::Identity()};
}

void read_friction(const JsonField& list, FrictionTable& table) {
  for (const JsonField& field : list.items()) {
    field.allow_only({"between", "static"});
    const std::vector<JsonField> pair = field["between"].items();
    if (pair.size() != 2) field["between"].fail("must name two materials");
    try {
      table.set(material_named(pair[0].text()), material_named(pair[1].text()),
                field["static"].number());
    } catch (const InputError& error) {
      field.fail(error.what());
    }
  }
}

void read_compliant_depths(const JsonField& object, CompliantDepths& depths) {
  for (const std::string& name : object.keys()) {
    const JsonField field = object[name];
    try {
      depths.set(material_named(name), field.number());
    } catch (const InputError& error) {
      field.fail(error.what());
    }
  }
}

// A name of the library, or a robot file: beside the scene if there is one.
Robot read_hand(const JsonField& field) {
  const std::string text = field.text();
  const std::filesystem::path beside = field.file().parent_path() / text;
  return find_robot(std::filesystem::is_regular_file(beside) ? beside.string() : text);
}

Scene read_scene(const JsonField& root, const SceneSource& source) {
  root.allow_only({"name", "object", "hand", "obstacles", "friction", "compliant_depths"});
  Scene scene;
  scene.name = root.text_or("name", root.file().stem().string());
  scene.object = read_object(root["object"]);
  if (root["object"].has("primitives")) {
    for (const JsonField& field : root["object"]["primitives"].items()) {
      scene.primitives.push_back(read_primitive(field));
    }
  }
  if (!source.hand.empty()) {
    scene.hand = find_robot(source.hand);
  } else {
    scene.hand = root.has("hand") ? read_hand(root["hand"]) : find_robot(kDefaultHand);
  }
  if (root.has("obstacles")) {
    for (const JsonField& field : root["obstacles"].items()) {
      scene.obstacles.push_back(read_obstacle(field));
    }
  }
  if (root.has("friction")) read_friction(root["friction"], scene.friction);
  if (root.has("compliant_depths"))
    read_compliant_depths(root["compliant_depths"], scene.compliant_depths);
  return scene;
}

}  // namespace

Scene load_scene(const std::filesystem::path& file, const SceneSource& source) {
  if (file.extension() == ".json") {
    const JsonFile json(file);
    return read_scene(json.root(), source);
  }
  Scene scene;
  scene.name = file.stem().string();
  scene.object = make_graspable(scene.name, mesh_from_file(file, source.unit), Material::plastic);
  scene.hand = find_robot(source.hand.empty() ? kDefaultHand : source.hand);
  return scene;
}

}  // namespace prehend
