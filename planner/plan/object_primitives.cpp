#include "planner/plan/object_primitives.h"

#include <utility>

namespace prehend {

std::vector<Primitive> object_primitives(const CompiledScene& scene, const DecomposeOptions& solids,
                                         const ThinPartOptions& thin_parts,
                                         const RunContext& context) {
  if (!scene.scene.primitives.empty()) return scene.scene.primitives;
  std::vector<Primitive> primitives =
      decompose(scene.scene.object.mesh, solids, context).primitives;
  for (Primitive& part : find_thin_parts(scene.object().mesh, primitives, thin_parts, context)) {
    primitives.push_back(std::move(part));
  }
  return primitives;
}

}  // namespace prehend
