// Parts of an object's surface that fingers must not touch, or had better touch.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/scene/color_region.h"
#include "sim/shape/files/mesh_file.h"
#include "sim/shape/mass_parts.h"
#include "sim/shape/primitive.h"
#include "sim/shape/proximity_mesh.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// What of the surface lies in a solid or beyond a plane, or is one part of the mesh file, or has
// some colour there.
struct SurfaceRegion {
  // The name in the file of a group, object or material of that part; empty: one of the others says
  // where.
  std::string part = {};
  std::optional<ColorRange> color = {};  // in place of `part`
  Primitive inside = {};                 // a solid, frame O
  // Of the part or the colour, frame O; known once the object is loaded.
  TriangleMesh surface = {};
  std::optional<BeyondPlane> beyond = {};  // in place of `inside`

  // Whether the mesh file says where: `surface` has the region.
  bool is_of_file() const { return color || !part.empty(); }
};

// What of a mesh file regions may refer to.
struct FileSurfaces {
  std::vector<MeshPart> parts = {};  // with their surfaces
  ColoredMesh colors = {};
};

// What may be said of a scene's object beside what its file says.
struct ObjectChoice {
  std::string object = {};                   // of several, by name; empty: the first
  std::vector<SurfaceRegion> keep_out = {};  // in addition
  std::vector<SurfaceRegion> preferred = {};
  double apart = 0.0;  // StaticBody::apart of the other objects [m]
};

// Whether the part has this name: its whole name, or its beginning or end as words.
bool is_part_called(const MeshPart& part, const std::string& name);

// The triangles of the parts of this name. Throws InputError that lists the names where there is
// none.
TriangleMesh part_surface(const std::string& name, const std::vector<MeshPart>& parts);

// Fills in the surface of a region that is of the file. Throws InputError as part_surface and
// color_surface.
void find_file_surface(const FileSurfaces& file, SurfaceRegion& region);

// Regions made ready to be asked for points. Copies share the search trees.
class SurfaceRegions {
 public:
  // A point this near to a region is in it [m]: contacts lie a little off the surface.
  static constexpr double kMargin = 2e-4;

  SurfaceRegions() = default;
  // The surfaces of parts and colours must be known.
  explicit SurfaceRegions(const std::vector<SurfaceRegion>& regions);

  bool empty() const { return shapes_.empty() && planes_.empty() && parts_.empty(); }
  // Whether the point is in one of them, or no farther than `margin` [m] from one of the file.
  bool contain(const Vector3& p_O, double margin = kMargin) const;

 private:
  std::vector<Primitive> shapes_;
  std::vector<BeyondPlane> planes_;
  std::vector<ProximityMesh> parts_;
};

}  // namespace prehend
