#include "sim/scene/object_friction.h"

#include <optional>

namespace prehend {

void set_static_friction(Scene& scene, Material a, Material b, double friction) {
  scene.friction.set(a, b, friction);
  const std::optional<double> kinetic = scene.kinetic_friction.between(a, b);
  if (kinetic && *kinetic > friction) scene.kinetic_friction.set(a, b, std::nullopt);
}

void set_object_friction(Scene& scene, double friction) {
  for (const Material other : kAll<Material>) {
    set_static_friction(scene, scene.object.material, other, friction);
  }
}

}  // namespace prehend
