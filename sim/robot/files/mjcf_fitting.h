// Primitives that MJCF fits to meshes: geoms that have a mesh and another type than "mesh".
#pragma once

#include <string>
#include <vector>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

struct FittedGeom {
  std::vector<double> size;      // as the attribute "size" gives it: half sizes [m]
  Pose X_MG = Pose::Identity();  // of the geom's frame in the mesh's
};

// The sphere, capsule, cylinder, ellipsoid or box (`type`) for a mesh, along its principal axes,
// the longest along z: of the box of even density that has the mesh's moments of inertia about the
// mesh's centre of mass; or, `to_bounds`, such that it holds the mesh's bounds in that frame, as a
// flat mesh gets it in any case. Source: MuJoCo, "XML reference", compiler/fitaabb and geom/mesh.
// Throws InputError for a mesh without a triangle of positive area, or another type.
FittedGeom fitted_geom(const TriangleMesh& mesh, const std::string& type, bool to_bounds);

}  // namespace prehend
