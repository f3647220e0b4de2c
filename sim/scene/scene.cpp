#include "sim/scene/scene.h"

#include <utility>

namespace prehend {

GraspableBody make_graspable(std::string name, TriangleMesh mesh, Material material, double mass) {
  const MassProperties properties = mass_properties(mesh);
  GraspableBody body;
  body.name = std::move(name);
  body.mesh = std::move(mesh);
  body.material = material;
  body.mass = mass;
  body.center_of_mass = properties.center_of_mass;
  body.inertia = mass * properties.unit_inertia;
  body.mass_source = properties.source;
  return body;
}

}  // namespace prehend
