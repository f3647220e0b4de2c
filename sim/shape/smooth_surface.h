// The smooth surface that a mesh stands for where its facets are fine enough: normals that vary
// from facet to facet, and a height above them.
#pragma once

#include <array>
#include <vector>

#include "sim/base/pose.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

class ProximityMesh;

// A surface that differs from its mesh by more than this has the facets of the mesh [m].
inline constexpr double kMostSag = 5e-5;

struct SmoothSurface {
  // Outward at each corner of each triangle, of all faces around the corner that follow each other
  // without a crease; of a triangle that differs too much from the surface its own normal.
  std::vector<std::array<Vector3, 3>> normals;
  bool is_curved = false;  // whether any triangle is
};

SmoothSurface smooth_surface(const ProximityMesh& proximity);

// The surface near a point of the mesh, to second order.
struct SmoothPoint {
  Vector3 normal = Vector3::UnitZ();    // outward, unit
  Matrix3 curvature = Matrix3::Zero();  // how the normal changes along the surface [1/m]
  double height = 0.0;                  // of the surface above the mesh [m]
  double reach = 0.0;                   // within which this holds [m]
  bool is_sharp = false;                // an edge or corner, which has no such surface
};

// Near point p of triangle t, which is also one of the triangles around it if it is on an edge or a
// corner: of that one whose normal is nearest to `outward`, unit. Where the surface is hollow its
// facets stand out of it; there it is taken kMostSag higher, so that what lies on it does not cross
// them. Source: quadratic triangles through corners with normals (Boubekeur and Alexa 2008, Phong
// Tessellation, with a shape factor of 1/2, which is exact for arcs to second order).
SmoothPoint smooth_point(const ProximityMesh& proximity, int t, const Vector3& p,
                         const Vector3& outward);

}  // namespace prehend
