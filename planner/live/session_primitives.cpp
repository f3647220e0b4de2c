#include "planner/live/session.h"
#include "planner/plan/search_settings.h"
#include "sim/base/input_error.h"

// Which primitives the object of a session has.
namespace prehend {

const ObjectPrimitives& Session::primitives() {
  const EditedScene& world = *state_.world;
  require(world.has_object(), {.field = "scene", .problem = world.problem()});
  const Scene& scene = world.scene();
  // Those that a scene states cost nothing, and may differ while the surface is the same.
  const std::string surface = scene.primitives.empty() ? world.surfaces().object : "";
  if (found_primitives_ && !surface.empty() && found_primitives_->surface == surface) {
    return found_primitives_->primitives;
  }
  const PlanOptions options = search_settings({});
  const RunContext context{.threads = options_.threads};
  const CompiledScene* parts = world.parts();
  found_primitives_ = {
      surface, parts != nullptr
                   ? object_primitives(scene, parts->object().mesh, options.primitives,
                                       options.thin_parts, context)
                   : object_primitives(scene, ProximityMesh(scene.object.mesh), options.primitives,
                                       options.thin_parts, context)};
  return found_primitives_->primitives;
}

}  // namespace prehend
