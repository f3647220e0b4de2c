// What candidates are made from: the primitives of an object.
#pragma once

#include <optional>
#include <vector>

#include "primitives/decompose.h"
#include "primitives/thin_parts.h"
#include "sim/base/run_context.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

struct ObjectPrimitives {
  std::vector<Primitive> all;
  // What decompose() says of the solids, which stand first in `all`; none where the scene states
  // the primitives.
  std::optional<Decomposition> solids = {};
};

// Those that the scene states, or else boxes, spheres, cylinders and cones of the mesh (decompose),
// then the rims and bars that these do not tell (find_thin_parts). `mesh`: that of the scene's
// object, in its frame. Throws InputError as decompose does, and Cancelled.
ObjectPrimitives object_primitives(const Scene& scene, const ProximityMesh& mesh,
                                   const DecomposeOptions& solids,
                                   const ThinPartOptions& thin_parts,
                                   const RunContext& context = {});
ObjectPrimitives object_primitives(const CompiledScene& scene, const DecomposeOptions& solids,
                                   const ThinPartOptions& thin_parts,
                                   const RunContext& context = {});

}  // namespace prehend
