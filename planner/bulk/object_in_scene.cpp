#include "planner/bulk/object_in_scene.h"

#include <utility>

#include "sim/scene/object_mass.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {
namespace {

Bounds bounds_in_world(const GraspableBody& object, const Pose& X_WO) {
  TriangleMesh turned = object.mesh;
  for (Vector3& vertex : turned.vertices) vertex = X_WO * vertex;
  return bounds(turned);
}

}  // namespace

void replace_object(Scene& scene, GraspableBody object) {
  const Bounds former = bounds_in_world(scene.object, scene.object.X_WO);
  const Bounds now = bounds_in_world(object, scene.object.X_WO);
  Vector3 shift = former.center() - now.center();
  shift.z() = former.lower.z() - now.lower.z();
  object.X_WO = scene.object.X_WO;
  object.X_WO.translation() += shift;
  scene.object = std::move(object);
  forget_surface(scene);
  note_uniform_mass(scene);
}

}  // namespace prehend
