// Compares sets of primitives of one object.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/shape/primitive.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend::bench {

// How many there are of each kind.
std::map<std::string, int> kinds_of(const std::vector<Primitive>& primitives);

// As "cylinder + 2 box".
std::string kinds_text(const std::vector<Primitive>& primitives);

// How far two sets are apart [m]: the mean distance of points of the surface of each from the
// nearest surface of the other, of both ways the larger. Neither the order of primitives nor the
// turn of a round one about its axis matters.
double distance_between(const std::vector<Primitive>& a, const std::vector<Primitive>& b);

// The set of an object that was moved and scaled.
std::vector<Primitive> moved_primitives(std::vector<Primitive> primitives, const Pose& X_NO,
                                        double factor);

// Of the distances of the surface of a mesh from the nearest of the primitives [m].
struct SurfaceResidual {
  double median = 0.0;
  double percentile_95 = 0.0;
};
SurfaceResidual residual_of(const TriangleMesh& mesh, const std::vector<Primitive>& primitives);

}  // namespace prehend::bench
