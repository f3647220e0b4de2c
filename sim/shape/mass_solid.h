// The solid over which the mass of a mesh is spread, at unit size.
#pragma once

#include "sim/shape/mass_properties.h"
#include "sim/shape/moments.h"

namespace prehend {

// In a frame that is moved to the centre of the mesh's bounds and scaled to a diagonal of 1: a
// point p of the mesh is at (p - center) / size.
struct MassSolid {
  MassSource source = MassSource::signed_volume;
  TriangleMesh surface;  // what bounds it, closed but for MassSource::surface
  Moments moments;       // of the solid, or of the surface
  Vector3 center = Vector3::Zero();
  double size = 1.0;

  Vector3 to_unit(const Vector3& p) const { return (p - center) / size; }
  Vector3 from_unit(const Vector3& p) const { return center + size * p; }
  // Whether there is a volume.
  bool is_solid() const { return source != MassSource::surface; }
  // Whether the pieces of the mesh are pieces of the solid: they are not of its convex hull.
  bool has_components() const {
    return source == MassSource::signed_volume || source == MassSource::closed_holes;
  }
};

// Throws InputError as mass_properties does.
MassSolid mass_solid(const TriangleMesh& mesh);

}  // namespace prehend
