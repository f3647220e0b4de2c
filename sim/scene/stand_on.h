// Bodies that are put down on others.
#pragma once

#include <optional>

#include "sim/base/pose.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {

// The pose of a body that was lowered from X_WB along -z of the world until it is 0.1 mm above the
// surface of `support`, not turned. Where it overlaps the support, or would fall past it, it is
// lowered from above all of it instead; nothing where it would fall past it from there, too.
std::optional<Pose> lowered_onto(const TriangleMesh& body, const Pose& X_WB,
                                 const TriangleMesh& support, const Pose& X_WS);

}  // namespace prehend
