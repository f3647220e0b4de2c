// Volume, centre of mass and inertia of the solid that a mesh bounds, at uniform density.
#pragma once

#include "sim/geometry/triangle_mesh.h"

namespace prehend {

enum class MassSource {
  signed_volume,   // closed, oriented mesh: exact integral (Mirtich 1996; Eberly 2002)
  convex_hull,     // open, inconsistent or hollow to nothing: the solid is the mesh's convex hull
  surface,         // flat or degenerate hull: mass spread evenly over the triangles, volume 0
};

struct MassProperties {
  MassSource source = MassSource::signed_volume;
  double volume = 0.0;                     // m^3
  Vector3 center_of_mass = Vector3::Zero();  // m, mesh frame
  Matrix3 unit_inertia = Matrix3::Zero();  // about the centre of mass, for a mass of 1 kg [m^2]
};

// Throws InputError for a mesh without triangles.
MassProperties mass_properties(const TriangleMesh& mesh);

}  // namespace prehend
