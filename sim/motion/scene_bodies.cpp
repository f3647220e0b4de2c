#include "sim/motion/scene_bodies.h"

#include <string>

#include "sim/base/input_error.h"
#include "sim/scene/scene.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

template <typename Body>
WorldBody world_body(const Body& body, const Pose& X_WB) {
  const bool is_solid = check_mesh(body.mesh).solid();
  WorldBody made{.name = body.name,
                 .shape = make_collision_body(body.name, body.mesh, is_solid),
                 .material = body.material};
  made.motion.X_WB = X_WB;
  made.restitution = body.restitution;
  made.surface = SurfaceMaterials(body.material, body.surfaces, made.shape.mesh);
  return made;
}

}  // namespace

ContactLaws laws_of(const Scene& scene) {
  ContactLaws laws;
  laws.friction = scene.friction;
  if (!scene.kinetic_friction.empty()) {
    laws.kinetic = sliding_friction(scene.friction, scene.kinetic_friction);
  }
  laws.compliant_depths = scene.compliant_depths;
  return laws;
}

void add_bodies(const Scene& scene, World& world) {
  const GraspableBody& object = scene.object;
  if (!(object.mass > 0.0)) {
    throw InputError({.field = object.name,
                      .problem = "needs a positive mass to move",
                      .value = std::to_string(object.mass)});
  }
  world.bodies.push_back(world_body(object, object.X_WO));
  world.bodies.back().inertial = {object.mass, object.center_of_mass, object.inertia};
  for (const StaticBody& obstacle : scene.obstacles) {
    world.bodies.push_back(world_body(obstacle, obstacle.X_WB));
    world.bodies.back().is_fixed = true;
  }
  world.laws = laws_of(scene);
}

}  // namespace prehend
