// Volume, centre of mass and inertia of the solid that a mesh bounds, at uniform density.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

// What the mass was taken to fill. The first that gives a plausible solid is used: volume between
// 1e-6 and 1 of the bounding box's, centre of mass inside that box, and an inertia that some solid
// can have.
enum class MassSource {
  // Exact integral over the solid that the surface bounds (Mirtich 1996; Eberly 2002), turned by
  // orient_outward. Every edge is run through as often one way as the other; parts may touch,
  // share edges or have hollows. Where parts overlap the mass counts twice.
  signed_volume,
  // The same after each hole was closed by triangles from its rim to the rim's mean point; the area
  // of these triangles is at most a quarter of the surface's.
  closed_holes,
  // The convex hull of the vertices: for scraps and soups of triangles.
  convex_hull,
  // Flat, without a hull: mass spread evenly over the triangles. Volume 0.
  surface,
};

// For people: "convex hull, the mesh is not closed".
constexpr std::string_view mass_source_name(MassSource source) {
  constexpr std::array<std::string_view, 4> kNames = {
      "signed volume", "signed volume, holes closed", "convex hull, the mesh is not closed",
      "surface, the mesh encloses nothing"};
  return kNames[static_cast<std::size_t>(source)];
}

// For the uniform density that fills the volume.
struct MassProperties {
  MassSource source = MassSource::signed_volume;
  double volume = 0.0;                       // m^3
  Vector3 center_of_mass = Vector3::Zero();  // m, mesh frame
  Matrix3 unit_inertia = Matrix3::Zero();    // about the centre of mass, for a mass of 1 kg [m^2]
};

// Throws InputError for a mesh without a triangle of positive area, with a vertex that is not
// finite or a triangle that refers to no vertex.
MassProperties mass_properties(const TriangleMesh& mesh);

}  // namespace prehend
