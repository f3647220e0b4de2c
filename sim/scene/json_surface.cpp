#include "sim/scene/json_surface.h"

#include <utility>

#include "sim/base/joined.h"
#include "sim/base/nearest_name.h"
#include "sim/base/range.h"
#include "sim/scene/json_region.h"
#include "sim/scene/scene.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLargestDepth = 1.0;  // m

SurfaceMaterial material_of(const JsonField& field, const NamedMaterials& named) {
  const std::string name = field.text();
  if (const std::optional<Material> known = value_named<Material>(name)) return {*known};
  if (const auto found = named.find(name); found != named.end()) return found->second;
  std::vector<std::string> names;
  for (const Material known : kAll<Material>) names.emplace_back(name_of(known));
  for (const auto& [own, material] : named) names.push_back(own);
  field.fail("unknown material; " + did_you_mean(name, names) + "known are " + joined(names));
}

double read_coefficient(const JsonField& field) {
  return with_field_errors(field, [&] { return checked_friction(field.number()); });
}

// One coefficient with all materials, or some by their names.
void read_own_friction(const JsonField& field, SurfaceMaterial& material) {
  if (!field.is_object()) {
    material.friction.entries.fill(read_coefficient(field));
    return;
  }
  for (const std::string& other : field.keys()) {
    const JsonField value = field[other];
    const Material with = with_field_errors(value, [&] { return material_named(other); });
    material.friction[with] = read_coefficient(value);
  }
}

SurfaceMaterial read_material(const JsonField& field, const std::string& name) {
  field.allow_only({"like", "friction", "compliant_depth"});
  if (name.empty()) field.fail("a material needs a name");
  if (value_named<Material>(name)) {
    field.fail(R"(is known already: "friction" and "compliant_depths" change it)");
  }
  SurfaceMaterial material = material_of(field["like"], {});
  material.name = name;
  if (field.has("friction")) read_own_friction(field["friction"], material);
  if (field.has("compliant_depth")) {
    material.compliant_depth =
        field["compliant_depth"].number({.lower = 0.0, .upper = kLargestDepth});
  }
  return material;
}

void add_materials(const std::vector<MaterialRegion>& surfaces, Json& json) {
  for (const auto& [where, of] : surfaces) {
    if (of.name.empty()) continue;
    Json material{{"like", name_of(of.material)}};
    for (const Material other : kAll<Material>) {
      if (of.friction[other]) {
        material["friction"][std::string(name_of(other))] = *of.friction[other];
      }
    }
    if (of.compliant_depth) material["compliant_depth"] = *of.compliant_depth;
    json[of.name] = material;
  }
}

}  // namespace

NamedMaterials read_materials(const JsonField& object) {
  NamedMaterials named;
  for (const std::string& name : object.keys()) {
    named.emplace(name, read_material(object[name], name));
  }
  return named;
}

std::vector<MaterialRegion> read_surfaces(const JsonField& list, const NamedMaterials& named) {
  std::vector<MaterialRegion> surfaces;
  for (const JsonField& field : list.items()) {
    field.allow_only({"part", "color", "within", "inside", "beyond", "material"});
    surfaces.push_back({read_region_fields(field), material_of(field["material"], named)});
  }
  return surfaces;
}

void find_surfaces(const JsonField& list, const FileSurfaces& file, const TriangleMesh& mesh,
                   std::vector<MaterialRegion>& surfaces) {
  const std::vector<JsonField> fields = list.items();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    SurfaceRegion& where = surfaces[i].where;
    if (where.is_of_file()) {
      const JsonField named = fields[i][where.color ? "color" : "part"];
      with_field_errors(named, [&] { where.surface = part_of_mesh(where, file, mesh); });
    }
    if (!has_surface_of(where, mesh)) fields[i].fail("must meet the surface");
  }
}

Json surfaces_to_json(const std::vector<MaterialRegion>& surfaces) {
  Json list = Json::array();
  for (const auto& [where, of] : surfaces) {
    list.push_back(region_to_json(where));
    list.back()["material"] = surface_name(of);
  }
  return list;
}

Json materials_to_json(const Scene& scene) {
  Json json = Json::object();
  add_materials(scene.object.surfaces, json);
  for (const StaticBody& body : scene.obstacles) add_materials(body.surfaces, json);
  for (const LinkSurfaces& link : scene.link_surfaces) add_materials(link.surfaces, json);
  return json;
}

}  // namespace prehend
