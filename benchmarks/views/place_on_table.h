// How things lie on a table.
#pragma once

#include "sim/shape/triangle_mesh.h"

namespace prehend::bench {

// The pose in which a body of uniform density stands on z = 0, its middle above the origin: as its
// file has it, with z up, where it stands so; else on the facet of its convex hull above which the
// centre of mass is lowest.
Pose pose_on_table(const TriangleMesh& mesh);

}  // namespace prehend::bench
