// What parts of a body's surface are made of, where that differs from the rest, and the friction
// between surfaces.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/material.h"
#include "sim/scene/friction_table.h"
#include "sim/scene/surface_region.h"

namespace prehend {

// A material, or one like it with properties of its own: wet glass.
struct SurfaceMaterial {
  Material material = Material::plastic;
  std::string name = {};  // of one with properties of its own; empty: that of the material
  // Static and kinetic, with surfaces of each material, in place of the scene's.
  EnumArray<Material, std::optional<double>> friction = {};
  std::optional<double> compliant_depth = {};  // in place of the material's [m]
};

// Its own name, else that of its material.
std::string surface_name(const SurfaceMaterial& surface);

// The coefficient of two surfaces: what one of them states of its own, of two such values the
// smaller, else that of the table.
double friction_between(const FrictionTable& table, const SurfaceMaterial& a,
                        const SurfaceMaterial& b);

// As CompliantDepths::between [m].
double depth_between(const CompliantDepths& depths, const SurfaceMaterial& a,
                     const SurfaceMaterial& b);

// A part of a surface and what it is made of.
struct MaterialRegion {
  SurfaceRegion where;
  SurfaceMaterial of;
};

// Whether any point of the mesh (body frame) is in the region, up to SurfaceRegions::kMargin.
bool has_surface_of(const SurfaceRegion& region, const TriangleMesh& mesh);

// The surface of a region of the file (find_file_surface), as triangles of `mesh`, which was made
// of the file and perhaps repaired: each triangle belongs to what the triangle of the file is of
// that its middle is nearest to, so that one that closes a hole belongs to what is around it.
// Throws InputError as find_file_surface.
TriangleMesh part_of_mesh(const SurfaceRegion& region, const FileSurfaces& file,
                          const TriangleMesh& mesh);

// The materials of a body's surface made ready to be asked for points. Copies share search trees.
class SurfaceMaterials {
 public:
  SurfaceMaterials() = default;  // uniform, of a material that nobody asks for
  // Which triangles belong to a part is decided here. A region may be empty; `surface` and regions
  // are in the body's frame.
  SurfaceMaterials(Material body, const std::vector<MaterialRegion>& regions,
                   const ProximityMesh& surface);

  bool uniform() const { return regions_.empty(); }
  // The number of the region at a point of the surface, frame of the body: of solids and half
  // spaces that contain the point and of parts that have the triangle nearest to it the last in the
  // list; -1: none. Regions reach SurfaceRegions::kMargin farther than stated.
  int region_at(const Vector3& p_B) const;
  // What region `i` is made of; -1: what the rest of the body is made of.
  const SurfaceMaterial& of(int i) const;
  const SurfaceMaterial& at(const Vector3& p_B) const { return of(region_at(p_B)); }
  int regions() const { return static_cast<int>(regions_.size()); }

  // Gives all of the surface this friction with surfaces of a material.
  void set_friction(Material other, double friction);

 private:
  SurfaceMaterial body_;
  std::vector<MaterialRegion> regions_;
  std::vector<int> part_of_;  // of each triangle: the last region that is a part with it; -1: none
  std::optional<ProximityMesh> surface_;  // where a region is a part
};

}  // namespace prehend
