#include "planner/plan/object_primitives.h"

#include <utility>

namespace prehend {

ObjectPrimitives object_primitives(const Scene& scene, const ProximityMesh& mesh,
                                   const DecomposeOptions& solids,
                                   const ThinPartOptions& thin_parts, const RunContext& context) {
  if (!scene.primitives.empty()) return {scene.primitives};
  ObjectPrimitives found;
  found.solids = decompose(scene.object.mesh, solids, context);
  found.all = found.solids->primitives;
  for (Primitive& part : find_thin_parts(mesh, found.all, thin_parts, context)) {
    found.all.push_back(std::move(part));
  }
  return found;
}

ObjectPrimitives object_primitives(const CompiledScene& scene, const DecomposeOptions& solids,
                                   const ThinPartOptions& thin_parts, const RunContext& context) {
  return object_primitives(scene.scene, scene.object().mesh, solids, thin_parts, context);
}

}  // namespace prehend
