#include "sim/scene/scene.h"

#include <array>
#include <utility>

#include "sim/base/formatted.h"
#include "sim/shape/files/mesh_file.h"

namespace prehend {

std::string unit_hint(const GraspableBody& object) {
  constexpr double kSmallestHeld = 0.01;  // m
  constexpr double kLargestHeld = 1.0;
  constexpr std::array<const char*, 4> kUnits = {"m", "cm", "mm", "in"};
  const double size = bounds(object.mesh).size().maxCoeff();
  const auto* file = std::get_if<MeshFileSource>(&object.source);
  if (file == nullptr || (size >= kSmallestHeld && size <= kLargestHeld)) return "";
  for (const char* unit : kUnits) {
    const double in_unit = size / metres_per_unit(file->unit) * metres_per_unit(unit);
    if (in_unit < kSmallestHeld || in_unit > kLargestHeld) continue;
    return formatted(" (%.3g mm if its unit were %s)", 1000.0 * in_unit, unit);
  }
  return "";
}

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

void forget_surface(Scene& scene) {
  scene.primitives.clear();
  scene.keep_out.clear();
  scene.preferred.clear();
  scene.porous.clear();
  scene.object.completion.reset();
  scene.object.surfaces.clear();
}

}  // namespace prehend
