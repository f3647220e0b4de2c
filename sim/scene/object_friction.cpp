#include "sim/scene/object_friction.h"

#include <optional>
#include <string>
#include <string_view>

#include "sim/base/formatted.h"

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
  // What is not the material's needs a name of its own, of which an earlier change is no part.
  constexpr std::string_view kChanged = " with friction ";
  for (MaterialRegion& region : scene.object.surfaces) {
    const std::string name = surface_name(region.of);
    region.of.name =
        name.substr(0, name.find(kChanged)) + std::string(kChanged) + formatted("%g", friction);
    region.of.friction.entries.fill(friction);
  }
  for (LinkSurfaces& link : scene.link_surfaces) {
    for (MaterialRegion& region : link.surfaces) {
      region.of.friction[scene.object.material].reset();
      for (const MaterialRegion& part : scene.object.surfaces) {
        region.of.friction[part.of.material].reset();
      }
    }
  }
}

}  // namespace prehend
