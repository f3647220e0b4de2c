// Spheres that stand for a body where a program knows no other shape.
#pragma once

#include <vector>

#include "sim/shape/proximity_mesh.h"

namespace prehend {

struct CoverSphere {
  Vector3 center_M = Vector3::Zero();  // frame of the mesh [m]
  double radius = 0.0;                 // [m]
};

// Spheres that together hold the whole surface. None of them reaches farther than `error` > 0 [m]
// out of the body. Greedy cover of points of the surface (Chvatal 1979, "A greedy heuristic for the
// set-covering problem") by spheres about points inside, each larger by `error` than its distance
// from the surface; where the surface encloses nothing, about points on it. The largest come first.
// The same mesh gives the same spheres.
std::vector<CoverSphere> sphere_cover(const ProximityMesh& mesh, double error);

}  // namespace prehend
