// Corrects fitted radii for tessellation: sampled points lie on facets, which cut inside the curved
// surface that the mesh approximates; only the vertices lie on that surface.
#pragma once

#include <span>

#include "primitives/surface_sample.h"
#include "sim/shape/primitive.h"

namespace prehend {

// The primitive with its radius, if it has one, measured at the vertices of the triangles that its
// points come from: points inside the facets of a polyhedron make it too small. Boxes stay.
Primitive on_vertices(const Primitive& primitive, std::span<const SurfacePoint> points,
                      const TriangleMesh& mesh);

}  // namespace prehend
