#include "sim/manipulation/grasp_world.h"

#include <cmath>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/dynamics/scene_world.h"

namespace prehend {
namespace {

Inertial object_inertial(const GraspableBody& object, const ProtocolObject& asked) {
  Inertial inertial{object.mass, object.center_of_mass, object.inertia};
  double mass = object.mass;
  if (asked.mass) mass = *asked.mass;
  if (asked.density) mass = *asked.density * mass_properties(object.mesh).volume;
  if (!(mass > 0.0)) {
    throw InputError({.field = object.name,
                      .problem = "has no mass to be shaken with",
                      .value = std::to_string(mass)});
  }
  inertial.inertia *= mass / inertial.mass;
  inertial.mass = mass;
  return inertial;
}

void set_laws(const CompiledScene& scene, const RobotModel& hand, const Protocol& protocol,
              ContactLaws& laws) {
  laws = laws_of(scene.scene);
  laws.torsion = protocol.torsion;
  if (!protocol.friction) return;
  for (const Material material : hand.materials) {
    laws.friction.set(material, scene.scene.object.material, *protocol.friction);
    if (laws.kinetic) {
      laws.kinetic->set(material, scene.scene.object.material, *protocol.friction);
    }
  }
}

}  // namespace

GraspPosture posture_of(const Trial& trial) { return {trial.X_OH, trial.dofs, trial.joints}; }

std::shared_ptr<const RobotModel> hand_model(const CompiledScene& scene,
                                             const RobotModelOptions& options) {
  return std::make_shared<const RobotModel>(make_robot_model(scene.scene.hand, options));
}

World make_grasp_world(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                       const GraspPosture& grasp, const Protocol& protocol) {
  World world;
  world.gravity = protocol.gravity;
  set_laws(scene, *hand, protocol, world.laws);
  const GraspableBody& object = scene.scene.object;
  WorldBody body{object.name, scene.object(), object.material};
  body.inertial = object_inertial(object, protocol.object);
  body.motion.X_WB = object.X_WO;
  body.restitution = object.restitution;
  world.bodies.push_back(std::move(body));
  if (protocol.on_support) {
    for (std::size_t i = 0; i < scene.scene.obstacles.size(); ++i) {
      const StaticBody& obstacle = scene.scene.obstacles[i];
      WorldBody fixed{obstacle.name, scene.obstacles()[i], obstacle.material};
      fixed.is_fixed = true;
      fixed.motion.X_WB = obstacle.X_WB;
      fixed.restitution = obstacle.restitution;
      world.bodies.push_back(std::move(fixed));
    }
  }
  world.robots.push_back(make_world_robot(scene.scene.hand.name, hand, object.X_WO * grasp.X_OH,
                                          grasp.dofs, grasp.joints));
  WorldRobot& robot = world.robots.back();
  for (Eigen::Index d = 0; d < hand->dofs(); ++d) {
    robot.drives.push_back({.dof = static_cast<int>(d), .holds_rate = true});
    robot.drives.back().max_effort = hand->effort[d];
  }
  return world;
}

std::vector<Drive> closing_drives(const RobotModel& hand) {
  std::vector<Drive> drives;
  for (Eigen::Index d = 0; d < hand.dofs(); ++d) {
    const DegreeOfFreedom& dof = hand.robot.dofs[index(static_cast<int>(d))];
    drives.push_back({.dof = static_cast<int>(d),
                      .target_rate = dof.closing_velocity,
                      .holds_rate = true,
                      .max_effort = hand.effort[d]});
  }
  return drives;
}

std::vector<Drive> opening_drives(const RobotModel& hand, const Eigen::VectorXd& now,
                                  const std::vector<double>& open) {
  constexpr double kThere = 1e-3;  // [rad or m]
  std::vector<Drive> drives = closing_drives(hand);
  for (Drive& drive : drives) {
    const double way = open[index(drive.dof)] - now[drive.dof];
    const double speed = std::abs(drive.target_rate);
    drive.target_rate = std::abs(way) > kThere ? std::copysign(speed, way) : 0.0;
  }
  return drives;
}

}  // namespace prehend
