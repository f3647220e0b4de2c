// Volume, centre of mass and inertia of the solid that a mesh bounds, at uniform density.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "sim/base/named_enum.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The solid over which the mass is assumed to be spread. mass_properties uses the first that is
// plausible: its volume is between 1e-6 and 1 of that of the bounding box, its centre of mass lies
// inside that box, and its inertia is one that a solid can have (positive second moments).
enum class MassSource {
  // Exact integral over the solid that the surface bounds (Mirtich 1996; Eberly 2002), after
  // orient_outward. Every edge is traversed equally often in both directions; components may touch,
  // share edges or be cavities. Where components overlap, the mass counts twice.
  signed_volume,
  // The same after every hole was closed by triangles from its rim to the mean of the rim's
  // vertices. Used only while the area of these triangles is at most a quarter of the surface's.
  closed_holes,
  // The convex hull of the vertices: for meshes with large holes and unconnected triangles.
  convex_hull,
  // The mass is spread evenly over the triangles: for flat meshes, which have no hull. Volume 0.
  surface,
};

// A phrase for reports, such as "convex hull, for holes or parts that overlap".
constexpr auto enum_names(MassSource /*of*/) {
  return std::to_array<std::string_view>({"signed volume", "signed volume, holes closed",
                                          "convex hull, for holes or parts that overlap",
                                          "surface, the mesh encloses nothing"});
}

// Mass properties at uniform density, without the density itself: multiply `volume` by a density
// [kg/m^3] for the mass [kg], and `unit_inertia` by the mass for the inertia [kg m^2].
struct MassProperties {
  MassSource source = MassSource::signed_volume;
  double volume = 0.0;                       // m^3
  Vector3 center_of_mass = Vector3::Zero();  // m, mesh frame
  Matrix3 unit_inertia = Matrix3::Zero();    // about the centre of mass, for a mass of 1 kg [m^2]
};

// Integrates over the mesh (see MassSource). Throws InputError when the mesh has no triangle of
// positive area, a vertex that is not finite or an index out of range.
MassProperties mass_properties(const TriangleMesh& mesh);

}  // namespace prehend
