// Meshes as scanners and other programs leave them: the same object with other triangles, with
// noise, with holes, seen from one side.
#pragma once

#include "sim/base/random.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::bench {

TriangleMesh scaled_mesh(TriangleMesh mesh, double factor);

// The same surface, with edges of at most `longest` [m].
TriangleMesh with_short_edges(TriangleMesh mesh, double longest);

// About as many triangles as edges of `cell` [m] need: the vertices of each cell of a grid become
// one, in their middle.
TriangleMesh clustered(const TriangleMesh& mesh, double cell);

// Each vertex moved along the normal of the surface, by normally distributed lengths.
TriangleMesh with_noise(TriangleMesh mesh, double deviation, Random& random);

// Without the triangles around `count` random places, which together have about `share` of the
// area.
TriangleMesh with_holes(const TriangleMesh& mesh, int count, double share, Random& random);

// What is seen from far away in direction `towards` (unit, from the object to the eye): triangles
// that face it and that no others hide. Edges must be short beside the object.
TriangleMesh seen_from(const TriangleMesh& mesh, const Vector3& towards);

}  // namespace prehend::bench
