// What holds for every mesh that a reader returns.
#pragma once

#include "sim/shape/triangle_mesh.h"

namespace prehend::fuzz {

// Triangles, all of whose corners exist, with finite coordinates. Throws BrokenPromise.
void check_usable(const TriangleMesh& mesh);

// Whether the numbers are finite.
bool finite(const Pose& pose);

}  // namespace prehend::fuzz
