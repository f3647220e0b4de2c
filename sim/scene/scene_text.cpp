#include "sim/scene/scene_text.h"

#include <variant>

#include "sim/base/input_error.h"
#include "sim/robot/files/platform_file.h"
#include "sim/scene/json_mass.h"
#include "sim/scene/json_primitive.h"
#include "sim/scene/json_region.h"
#include "sim/scene/json_surface.h"

// A body is written by its source where it has one (a mesh file, the name of a generated object,
// the shapes of a scene file), so that the text is short and reads back as the same body. Only
// meshes that a program has made are written triangle by triangle.
namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

Json triangles_json(const TriangleMesh& mesh) {
  Json shape{{"shape", "triangles"}, {"vertices", Json::array()}, {"triangles", Json::array()}};
  for (const Vector3& v : mesh.vertices) shape["vertices"].push_back(vector_to_json(v));
  for (const Triangle& t : mesh.triangles) shape["triangles"].push_back(t);
  return Json::array({shape});
}

// JSON has no way to name a path that is not UTF-8.
bool can_be_named(const std::string& path) {
  try {
    (void)Json(path).dump();
    return true;
  } catch (const Json::type_error&) {
    return false;
  }
}

// The fields of a body that say where its surface comes from.
struct ShapeSourceFields {
  const TriangleMesh& mesh;

  Json operator()(std::monostate /*none*/) const { return {{"geometry", triangles_json(mesh)}}; }
  Json operator()(const MeshFileSource& source) const {
    if (!can_be_named(source.path)) return (*this)(std::monostate{});
    Json fields{{"mesh", source.path}, {"unit", source.unit}};
    if (!source.repair) fields["repair"] = false;
    return fields;
  }
  Json operator()(const GeneratedSource& source) const {
    return {{"generate", source.name}, {"triangles", source.triangles}};
  }
  Json operator()(const WrittenShapesSource& source) const {
    return {{"geometry", Json::parse(source.geometry)}};
  }
  Json operator()(const ViewsSource& /*source*/) const { return (*this)(std::monostate{}); }
};

template <typename Body>
Json body_json(const Body& body, const Pose& X_WB) {
  Json json{{"name", body.name}};
  json.update(std::visit(ShapeSourceFields{body.mesh}, body.source));
  json["material"] = name_of(body.material);
  json["pose"] = pose_to_json(X_WB);
  if (body.restitution > 0.0) json["restitution"] = body.restitution;
  if (!body.surfaces.empty()) json["surfaces"] = surfaces_to_json(body.surfaces);
  return json;
}

Json object_json(const Scene& scene) {
  Json json = body_json(scene.object, scene.object.X_WO);
  add_mass(scene.object, json);
  for (const Primitive& primitive : scene.primitives) {
    json["primitives"].push_back(primitive_to_json(primitive));
  }
  if (!scene.keep_out.empty()) json["keep_out"] = regions_to_json(scene.keep_out);
  if (!scene.preferred.empty()) json["preferred"] = regions_to_json(scene.preferred);
  if (!scene.porous.empty()) json["porous"] = regions_to_json(scene.porous);
  return json;
}

// What the scene says of the platform: where it stands, where it starts, and limits that are not
// its own.
Json carrier_json(const Scene& scene) {
  const Carrier& carrier = *scene.carrier;
  if (carrier.source.empty()) throw InputError({scene.name, "robot", "has no file to be named by"});
  // Limits are compared with those of the platform's file, which is read again: the carrier holds
  // the limits as the scene has narrowed them.
  const Platform own = find_platform(carrier.source);
  Json json{{"platform", carrier.source}, {"pose", pose_to_json(carrier.X_WB)}};
  std::size_t next = 0;
  for (std::size_t r = 0; r < carrier.platform.robots.size(); ++r) {
    const MountedRobot& mounted = carrier.platform.robots[r];
    const bool replaced = static_cast<int>(r) == carrier.hand && !scene.hand_source.empty();
    for (std::size_t d = 0; d < mounted.robot.dofs.size(); ++d) {
      const DegreeOfFreedom& dof = mounted.robot.dofs[d];
      const std::string name = mounted.name + "/" + dof.name;
      json["start"][name] = carrier.start[next++];
      // A hand that replaces the platform's own has other degrees of freedom, with which no limits
      // can be compared.
      if (replaced) continue;
      const DegreeOfFreedom& its_own = own.robots[r].robot.dofs[d];
      if (dof.lower != its_own.lower || dof.upper != its_own.upper) {
        json["limits"][name] = {dof.lower, dof.upper};
      }
    }
  }
  return json;
}

// Only what differs from the table that everybody has.
Json friction_json(const Scene& scene) {
  const FrictionTable standard;
  Json json = Json::array();
  for (std::size_t a = 0; a < kAll<Material>.size(); ++a) {
    for (std::size_t b = a; b < kAll<Material>.size(); ++b) {
      const double friction = scene.friction.between(kAll<Material>[a], kAll<Material>[b]);
      const auto kinetic = scene.kinetic_friction.between(kAll<Material>[a], kAll<Material>[b]);
      const auto deviation =
          scene.friction_deviations.between(kAll<Material>[a], kAll<Material>[b]);
      const bool is_standard = friction == standard.between(kAll<Material>[a], kAll<Material>[b]);
      if (is_standard && !kinetic && !deviation) continue;
      json.push_back({{"between", {name_of(kAll<Material>[a]), name_of(kAll<Material>[b])}},
                      {"static", friction}});
      if (kinetic) json.back()["kinetic"] = *kinetic;
      if (deviation) json.back()["deviation"] = *deviation;
    }
  }
  return json;
}

Json compliant_json(const CompliantDepths& depths) {
  const CompliantDepths standard;
  Json json = Json::object();
  for (const Material material : kAll<Material>) {
    if (depths.of(material) == standard.of(material)) continue;
    json[std::string(name_of(material))] = depths.of(material);
  }
  return json;
}

}  // namespace

std::string scene_text(const Scene& scene) {
  Json json{{"name", scene.name}, {"object", object_json(scene)}};
  if (scene.carrier) {
    json["robot"] = carrier_json(scene);
    if (!scene.hand_source.empty()) json["robot"]["hand"] = scene.hand_source;
  } else {
    if (scene.hand_source.empty()) {
      throw InputError({scene.name, "hand", "has no file to be named by"});
    }
    json["hand"] = scene.hand_source;
  }
  for (const StaticBody& body : scene.obstacles) {
    json["obstacles"].push_back(body_json(body, body.X_WB));
    if (body.apart > 0.0) json["obstacles"].back()["apart"] = body.apart;
  }
  if (const Json friction = friction_json(scene); !friction.empty()) {
    json["friction"] = friction;
  }
  if (const Json depths = compliant_json(scene.compliant_depths); !depths.empty()) {
    json["compliant_depths"] = depths;
  }
  for (const LinkSurfaces& link : scene.link_surfaces) {
    json["link_surfaces"][link.link] = surfaces_to_json(link.surfaces);
  }
  if (const Json materials = materials_to_json(scene); !materials.empty()) {
    json["materials"] = materials;
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace prehend
