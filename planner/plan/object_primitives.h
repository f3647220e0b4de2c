// What candidates are made from: the primitives of an object.
#pragma once

#include <vector>

#include "primitives/decompose.h"
#include "primitives/thin_parts.h"
#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

// Those that the scene states, or else boxes, spheres, cylinders and cones of the mesh (decompose),
// then the rims and bars that these do not tell (find_thin_parts). Throws Cancelled.
std::vector<Primitive> object_primitives(const CompiledScene& scene, const DecomposeOptions& solids,
                                         const ThinPartOptions& thin_parts,
                                         const RunContext& context = {});

}  // namespace prehend
