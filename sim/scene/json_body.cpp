#include "sim/scene/json_body.h"

#include <filesystem>
#include <string>
#include <utility>

#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/base/json/json_pose.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mesh_repair.h"
#include "sim/shape/object_generator.h"

namespace prehend {
namespace {

// A surface, and what of its file was asked for.
struct BodyMesh {
  TriangleMesh mesh;
  FileSurfaces of_file = {};
};

BodyMesh mesh_from_file(const std::filesystem::path& file, double metres_per_unit,
                        const NeededSurfaces& needed) {
  LoadedMesh loaded = load_mesh(
      file,
      {.metres_per_unit = metres_per_unit, .part_surfaces = needed.parts, .colors = needed.colors});
  orient_outward(loaded.mesh);
  return {std::move(loaded.mesh), {std::move(loaded.parts), std::move(loaded.colors)}};
}

constexpr int kDefaultTriangles = 5000;

int read_triangles(const JsonField& body) {
  return body.has("triangles") ? body["triangles"].integer() : kDefaultTriangles;
}

// Metres per unit of the body's mesh file.
double read_unit(const JsonField& body) {
  if (!body.has("unit")) return 1.0;
  const JsonField field = body["unit"];
  return with_field_errors(field, [&] { return metres_per_unit(field.text()); });
}

// Exactly one of "mesh" (a file beside the scene), "generate" (a name) and "geometry" (shapes).
BodyMesh read_body_mesh(const JsonField& body, ShapeBudget& budget,
                        const NeededSurfaces& needed = {}) {
  const int given = int{body.has("mesh")} + int{body.has("generate")} + int{body.has("geometry")};
  if (given != 1) body.fail("needs exactly one of mesh, generate, geometry");
  if (body.has("mesh")) {
    const std::filesystem::path file = body.file().parent_path() / body["mesh"].text();
    return mesh_from_file(file, read_unit(body), needed);
  }
  if (body.has("geometry")) return {read_geometry(body["geometry"], FileUnits{}, {}, budget)};
  try {
    return {generate_object(body["generate"].text(), read_triangles(body))};
  } catch (const InputError& error) {
    body[error.field() == "triangles" ? "triangles" : "generate"].fail_about(error);
  }
}

std::string absolute_path(const std::filesystem::path& file) {
  return std::filesystem::absolute(file).lexically_normal().string();
}

}  // namespace

Material read_material(const JsonField& body, Material otherwise) {
  if (!body.has("material")) return otherwise;
  const JsonField field = body["material"];
  return with_field_errors(field, [&] { return material_named(field.text()); });
}

double read_restitution(const JsonField& body) {
  return body.number_or("restitution", 0.0, kFraction);
}

ShapeSource read_source(const JsonField& body) {
  if (body.has("mesh")) {
    return MeshFileSource{absolute_path(body.file().parent_path() / body["mesh"].text()),
                          body.text_or("unit", "m")};
  }
  if (body.has("generate")) return GeneratedSource{body["generate"].text(), read_triangles(body)};
  return WrittenShapesSource{body["geometry"].json()};
}

ObjectMesh read_object_mesh(const JsonField& field, bool repair, const NeededSurfaces& needed,
                            ShapeBudget& budget) {
  if (!field.has("mesh") || field.has("generate") || field.has("geometry")) {
    return {.mesh = read_body_mesh(field, budget).mesh, .unit = "m"};
  }
  (void)read_unit(field);
  const std::filesystem::path file = field.file().parent_path() / field["mesh"].text();
  return load_object_mesh(file, {field.text_or("unit", "m"), repair, needed.parts, needed.colors});
}

std::vector<MaterialRegion> read_body_surfaces(const JsonField& body, const NamedMaterials& named) {
  if (!body.has("surfaces")) return {};
  return read_surfaces(body["surfaces"], named);
}

StaticBody read_obstacle(const JsonField& field, const NamedMaterials& named, ShapeBudget& budget) {
  field.allow_only({"name", "mesh", "unit", "generate", "triangles", "geometry", "material", "pose",
                    "restitution", "surfaces", "apart"});
  std::vector<MaterialRegion> surfaces = read_body_surfaces(field, named);
  NeededSurfaces needed;
  needed.add(surfaces);
  BodyMesh read = read_body_mesh(field, budget, needed);
  if (field.has("surfaces")) find_surfaces(field["surfaces"], read.of_file, read.mesh, surfaces);
  StaticBody body{field["name"].text(),
                  std::move(read.mesh),
                  Pose::Identity(),
                  read_material(field, Material::wood),
                  {}};
  if (field.has("pose")) body.X_WB = read_pose(field["pose"]);
  body.restitution = read_restitution(field);
  body.apart = field.number_or("apart", 0.0, kApart);
  body.surfaces = std::move(surfaces);
  body.source = read_source(field);
  return body;
}

}  // namespace prehend
