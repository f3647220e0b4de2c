// The triangles of a mesh that are nearest to a point.
#pragma once

#include <vector>

#include "sim/shape/proximity_mesh.h"

namespace prehend {

// Replaces `triangles` by those whose distance from p_M (mesh frame) is at most `margin` [m] larger
// than the least, in ascending order; `margin` > 0. Never empty.
void nearest_triangles(const ProximityMesh& mesh, const Vector3& p_M, double margin,
                       std::vector<int>& triangles);

}  // namespace prehend
