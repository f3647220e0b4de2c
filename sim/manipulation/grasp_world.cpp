#include "sim/manipulation/grasp_world.h"

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/scene/compiled_scene.h"
#include "sim/trial/trial.h"

namespace prehend {
namespace {

void set_mass(const GraspableBody& object, const ProcedureObject& asked, Inertial& inertial) {
  double mass = inertial.mass;
  if (asked.mass) mass = *asked.mass;
  if (asked.density) mass = *asked.density * mass_properties(object.mesh).volume;
  if (!(mass > 0.0)) {
    throw InputError({.field = object.name,
                      .problem = "has no mass to be shaken with",
                      .value = std::to_string(mass)});
  }
  inertial.inertia *= mass / inertial.mass;
  inertial.mass = mass;
}

// Of its links and their regions.
std::vector<Material> materials_of(const RobotModel& robot) {
  std::vector<Material> materials = robot.materials;
  for (const SurfaceMaterials& surface : robot.surfaces) {
    for (int i = 0; i < surface.regions(); ++i) materials.push_back(surface.of(i).material);
  }
  return materials;
}

}  // namespace

GraspPosture posture_of(const Trial& trial) {
  return {trial.X_OH, trial.dofs, trial.joints, trial.X_OC.value_or(Pose::Identity())};
}

void require_support(const CompiledScene& scene, const TestProcedure& procedure) {
  require(
      scene.scene.hand.hand->cups.empty(),
      {.field = "test procedure",
       .problem = "the vacuum of suction cups is not simulated, hand " + scene.scene.hand.name});
  if (!procedure.on_support || scene.has_obstacles()) return;
  throw InputError({.field = "on_support",
                    .problem = "protocol " + procedure.name +
                               " begins with an object on a support; " +
                               "the scene has nothing that could bear " + scene.scene.object.name});
}

void follow_test_procedure(const CompiledScene& scene, const RobotModel& robot,
                           const TestProcedure& procedure, World& world) {
  require_support(scene, procedure);
  world.gravity = procedure.gravity;
  set_mass(scene.scene.object, procedure.object, world.bodies[index(kObjectBody)].inertial);
  world.laws.torsion = procedure.torsion;
  if (!procedure.friction) return;
  for (const Material material : materials_of(robot)) {
    world.bodies[index(kObjectBody)].surface.set_friction(material, *procedure.friction);
    world.laws.friction.set(material, scene.scene.object.material, *procedure.friction);
    if (world.laws.kinetic) {
      world.laws.kinetic->set(material, scene.scene.object.material, *procedure.friction);
    }
  }
}

GraspWorld make_grasp_world(const CompiledScene& scene,
                            const std::shared_ptr<const RobotModel>& hand,
                            const GraspPosture& grasp, const TestProcedure& procedure) {
  GraspWorld grasped{make_scene_world(scene, procedure.on_support), {}};
  follow_test_procedure(scene, *hand, procedure, grasped.world);
  Pose& X_WO = grasped.world.bodies[index(kObjectBody)].motion.X_WB;
  X_WO = X_WO * grasp.X_OC;
  grasped.hand = add_hand(grasped.world, scene, hand, X_WO * grasp.X_OH, grasp.dofs, grasp.joints);
  return grasped;
}

}  // namespace prehend
