// Bodies of scene files: their surfaces, materials and obstacles (docs/reference/scene-file.md).
#pragma once

#include <vector>

#include "sim/base/range.h"
#include "sim/robot/files/robot_geometry.h"
#include "sim/scene/json_surface.h"
#include "sim/scene/object_mesh.h"
#include "sim/scene/scene.h"

namespace prehend {

class JsonField;  // sim/base/json/json_field.h

inline constexpr Range kApart{.upper = 1.0};  // StaticBody::apart [m]

// What of a mesh file regions refer to, which is read for them.
struct NeededSurfaces {
  bool parts = false;
  bool colors = false;

  void add(const SurfaceRegion& region) {
    parts |= !region.part.empty();
    colors |= region.color.has_value();
  }
  void add(const std::vector<SurfaceRegion>& regions) {
    for (const SurfaceRegion& region : regions) add(region);
  }
  void add(const std::vector<MaterialRegion>& surfaces) {
    for (const MaterialRegion& surface : surfaces) add(surface.where);
  }
  bool any() const { return parts || colors; }
};

// Fields of a body. These functions throw InputError that names the field.
Material read_material(const JsonField& body, Material otherwise);
double read_restitution(const JsonField& body);
// The regions in "surfaces" of a body or a link.
std::vector<MaterialRegion> read_body_surfaces(const JsonField& body, const NamedMaterials& named);
ShapeSource read_source(const JsonField& body);

// The surface of an object: exactly one of "mesh" (a file beside the scene), "generate" (a name)
// and "geometry" (shapes).
ObjectMesh read_object_mesh(const JsonField& field, bool repair, const NeededSurfaces& needed,
                            ShapeBudget& budget);

StaticBody read_obstacle(const JsonField& field, const NamedMaterials& named, ShapeBudget& budget);

}  // namespace prehend
