// Meshes of the shapes that files of other programs name, in the numbers of triangles that
// planning needs.
#pragma once

#include <cstddef>
#include <filesystem>

#include "sim/shape/triangle_mesh.h"

namespace prehend {

// All shapes of a file together may have so many triangles: one sphere of some fifty bytes becomes
// hundreds, so that a small file could fill the memory.
inline constexpr std::size_t kMostShapeTriangles = 200'000;

// A cylinder along z, centred at the origin, whose corners are on the circle [m]. This and those
// below throw InputError for sizes that are not positive.
TriangleMesh cylinder_mesh(double radius, double height);
TriangleMesh sphere_mesh(double radius);
// A cylinder along z with half a ball on each end; `height` is that of the cylinder alone [m].
TriangleMesh capsule_mesh(double radius, double height);
// The ball scaled along the axes to these radii [m].
TriangleMesh ellipsoid_mesh(const Vector3& radii);

// The mesh with each coordinate multiplied; mirrored, its triangles still face outward. Throws
// InputError for a factor of 0.
TriangleMesh scaled(TriangleMesh mesh, const Vector3& factors);

// The mesh of a file as load_mesh reads it, but empty where it has no triangles: one of a robot's
// many parts.
TriangleMesh mesh_or_nothing(const std::filesystem::path& file);

}  // namespace prehend
