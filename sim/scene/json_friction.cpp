#include "sim/scene/json_friction.h"

#include <optional>
#include <string>
#include <vector>

#include "sim/base/json/json_field.h"
#include "sim/scene/object_friction.h"

namespace prehend {

void read_friction(const JsonField& list, Scene& scene) {
  for (const JsonField& field : list.items()) {
    field.allow_only({"between", "static", "kinetic", "deviation"});
    const std::vector<JsonField> pair = field["between"].items();
    if (pair.size() != 2) field["between"].fail("must name two materials");
    const auto material = [](const JsonField& name) {
      return with_field_errors(name, [&] { return material_named(name.text()); });
    };
    const Material a = material(pair[0]);
    const Material b = material(pair[1]);
    scene.kinetic_friction.set(a, b, std::nullopt);
    scene.friction_deviations.set(a, b, std::nullopt);
    if (field.has("deviation")) {
      const JsonField deviation = field["deviation"];
      with_field_errors(deviation,
                        [&] { scene.friction_deviations.set(a, b, deviation.number()); });
    }
    if (field.has("static") || !(field.has("kinetic") || field.has("deviation"))) {
      const JsonField friction = field["static"];
      with_field_errors(friction, [&] { scene.friction.set(a, b, friction.number()); });
    }
    if (!field.has("kinetic")) continue;
    const JsonField kinetic = field["kinetic"];
    with_field_errors(kinetic, [&] { scene.kinetic_friction.set(a, b, kinetic.number()); });
    if (kinetic.number() > scene.friction.between(a, b)) {
      kinetic.fail("must be at most the static coefficient of the pair");
    }
  }
}

void read_object_friction(const JsonField& root, Scene& scene) {
  const auto read = [&](const JsonField& object) {
    if (!object.has("friction")) return;
    const JsonField field = object["friction"];
    const double friction = field.number();
    with_field_errors(field, [&] {
      set_object_friction(scene, friction);
      return 0;
    });
  };
  if (root.has("object")) read(root["object"]);
  if (!root.has("objects")) return;
  for (const JsonField& object : root["objects"].items()) {
    if (object["name"].text() == scene.object.name) read(object);
  }
}

void read_compliant_depths(const JsonField& object, CompliantDepths& depths) {
  for (const std::string& name : object.keys()) {
    const JsonField field = object[name];
    with_field_errors(field, [&] { depths.set(material_named(name), field.number()); });
  }
}

}  // namespace prehend
