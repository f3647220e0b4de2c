#include "sim/scene/json_mass.h"

#include <variant>

#include "sim/base/range.h"
#include "sim/scene/json_primitive.h"
#include "sim/scene/object_mass.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

std::optional<double> read_number(const JsonField& field, const char* key) {
  if (!field.has(key)) return std::nullopt;
  return field[key].number();
}

MassPart read_part(const JsonField& field) {
  field.allow_only({"name", "component", "inside", "beyond", "at", "density", "mass"});
  MassPart part{
      .where = {}, .density = read_number(field, "density"), .mass = read_number(field, "mass")};
  if (field.has("name")) part.name = field["name"].text();
  const int given = int{field.has("component")} + int{field.has("inside")} +
                    int{field.has("beyond")} + int{field.has("at")};
  if (given != 1) field.fail("needs exactly one of component, inside, beyond, at");
  if (field.has("component")) part.where = MeshComponent{field["component"].integer()};
  if (field.has("inside")) part.where = InsideShape{read_primitive(field["inside"])};
  if (field.has("beyond")) part.where = read_beyond(field["beyond"]);
  if (field.has("at")) part.where = AtPoint{field["at"].vector3(kCoordinate)};
  return part;
}

StatedMass read_stated(const JsonField& object) {
  StatedMass stated{read_number(object, "mass"), read_number(object, "density"), {}};
  if (object.has("parts")) {
    for (const JsonField& part : object["parts"].items()) stated.parts.push_back(read_part(part));
    if (stated.parts.empty()) object["parts"].fail("must have at least one part");
    if (object.has("center_of_mass")) {
      object["center_of_mass"].fail("not beside parts, from which it follows");
    }
  } else if (stated.mass && stated.density) {
    object["density"].fail("not beside mass, where there are no parts");
  }
  return stated;
}

struct RegionFields {
  Json operator()(const MeshComponent& component) const { return {{"component", component.index}}; }
  Json operator()(const InsideShape& inside) const {
    return {{"inside", primitive_to_json(inside.shape)}};
  }
  Json operator()(const BeyondPlane& beyond) const { return {{"beyond", beyond_to_json(beyond)}}; }
  Json operator()(const AtPoint& at) const { return {{"at", vector_to_json(at.p_O)}}; }
};

Json part_json(const MassPart& part) {
  Json json = Json::object();
  if (!part.name.empty()) json["name"] = part.name;
  json.update(std::visit(RegionFields{}, part.where));
  if (part.density) json["density"] = *part.density;
  if (part.mass) json["mass"] = *part.mass;
  return json;
}

}  // namespace

double whole_mass(const JsonField& object) {
  return object.number_or("mass", kDefaultObjectMass, kMass);
}

void read_mass(const JsonField& object, GraspableBody& body) {
  const StatedMass stated = read_stated(object);
  if (stated.density || !stated.parts.empty()) {
    try {
      state_mass(body, stated);
    } catch (const InputError& error) {
      object.fail(error);
    }
    if (body.mass > kLargestMass) object.fail("weighs more than 1e9 kg");
  }
  if (object.has("center_of_mass")) {
    state_center_of_mass(body, object["center_of_mass"].vector3(kCoordinate));
  }
}

void add_mass(const GraspableBody& body, Json& json) {
  json["mass"] = body.mass;
  // The mesh file says the rest again.
  if (body.mass_basis == MassBasis::materials) return;
  if (body.stated_mass) {
    if (body.stated_mass->density) json["density"] = *body.stated_mass->density;
    for (const MassPart& part : body.stated_mass->parts) json["parts"].push_back(part_json(part));
    return;
  }
  // A program may have moved the centre without saying so.
  if (body.mass_basis == MassBasis::uniform &&
      body.center_of_mass == mass_properties(body.mesh).center_of_mass) {
    return;
  }
  json["center_of_mass"] = vector_to_json(body.center_of_mass);
}

}  // namespace prehend
