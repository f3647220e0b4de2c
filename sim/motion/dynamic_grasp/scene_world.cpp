#include "sim/motion/dynamic_grasp/scene_world.h"

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/motion/dynamic_grasp/hand_drives.h"
#include "sim/motion/scene_bodies.h"
#include "sim/motion/solids.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {
namespace {

WorldBody object_body(const CompiledScene& scene) {
  const GraspableBody& object = scene.scene.object;
  if (!(object.mass > 0.0)) {
    throw InputError({.field = object.name,
                      .problem = "has no mass to be moved with",
                      .value = std::to_string(object.mass)});
  }
  WorldBody body{object.name, scene.object(), object.material};
  body.inertial = {object.mass, object.center_of_mass, object.inertia};
  body.motion.X_WB = object.X_WO;
  body.restitution = object.restitution;
  body.surface = scene.object_surface;
  return body;
}

std::vector<double> part_of(const Eigen::VectorXd& values, int first, int count) {
  const auto begin = values.data() + first;
  return {begin, begin + count};
}

}  // namespace

std::shared_ptr<const RobotModel> hand_model(const CompiledScene& scene) {
  RobotModel model = make_robot_model(scene.scene.hand);
  if (!scene.scene.link_surfaces.empty()) {
    for (const CompiledLink& link : scene.links) model.surfaces.push_back(link.surface);
  }
  return std::make_shared<const RobotModel>(std::move(model));
}

std::shared_ptr<const RobotModel> platform_model(const CompiledScene& scene) {
  RobotModel model = make_robot_model(scene.arm->robot());
  if (!scene.scene.link_surfaces.empty()) {
    // The hand's links come as they are in the hand.
    model.surfaces.resize(model.robot.links.size());
    for (std::size_t l = 0, of_hand = 0; l < model.surfaces.size(); ++l) {
      if (scene.arm->is_hand_link(link_id(l))) model.surfaces[l] = scene.links[of_hand++].surface;
    }
  }
  return std::make_shared<const RobotModel>(std::move(model));
}

World make_scene_world(const CompiledScene& scene, bool obstacles) {
  std::vector<BodyId> all;
  for (std::size_t i = 0; obstacles && i < scene.scene.obstacles.size(); ++i) {
    all.push_back(BodyId::obstacle(static_cast<int>(i)));
  }
  return make_scene_world(scene, all);
}

World make_scene_world(const CompiledScene& scene, const std::vector<BodyId>& obstacles) {
  World world;
  world.laws = laws_of(scene.scene);
  world.bodies.push_back(object_body(scene));
  for (const BodyId id : obstacles) {
    const std::size_t i = index(id) - 1;  // behind the object
    const StaticBody& obstacle = scene.scene.obstacles[i];
    WorldBody fixed{obstacle.name, scene.obstacles()[i], obstacle.material};
    fixed.is_fixed = true;
    fixed.motion.X_WB = obstacle.X_WB;
    fixed.restitution = obstacle.restitution;
    fixed.surface = SurfaceMaterials(obstacle.material, obstacle.surfaces, fixed.shape.mesh);
    world.bodies.push_back(std::move(fixed));
  }
  return world;
}

WorldHand add_hand(World& world, const CompiledScene& scene,
                   const std::shared_ptr<const RobotModel>& hand, const Pose& X_WH,
                   const std::vector<double>& dofs, const std::vector<double>& joints) {
  WorldHand place{.robot = static_cast<int>(world.robots.size())};
  place.dofs = static_cast<int>(hand->dofs());
  place.joints = static_cast<int>(hand->robot.joints.size());
  place.links = static_cast<int>(hand->robot.links.size());
  world.robots.push_back(make_world_robot(scene.scene.hand.name, hand, X_WH, dofs, joints));
  world.robots.back().drives = holding_drives(*hand, place);
  return place;
}

WorldHand add_platform(World& world, const CompiledScene& scene,
                       const std::shared_ptr<const RobotModel>& platform,
                       const std::vector<double>& dofs, const std::vector<double>& joints) {
  const CompiledArm& arm = *scene.arm;
  const PlatformPart& part = arm.hand_part();
  WorldHand place{.robot = static_cast<int>(world.robots.size()),
                  .joint = part.joint,
                  .X_JH = part.X_JR,
                  .first_dof = part.first_dof,
                  .dofs = static_cast<int>(scene.scene.hand.dofs.size()),
                  .first_joint = part.first_joint,
                  .joints = static_cast<int>(scene.scene.hand.joints.size()),
                  .first_link = part.first_link,
                  .links = arm.hand_link_count};
  world.robots.push_back(make_world_robot(arm.robot().name, platform, arm.X_WB, dofs, joints));
  world.robots.back().is_balanced = true;
  world.robots.back().drives = holding_drives(*platform, place);
  return place;
}

Pose hand_pose(const World& world, const WorldHand& hand) {
  const WorldRobot& robot = world.robots[index(hand.robot)];
  if (hand.is_free()) return robot.X_WB * hand.X_JH;
  return state_of(robot).X_WA[index(hand.joint)] * hand.X_JH;
}

std::vector<double> hand_dofs(const World& world, const WorldHand& hand) {
  return part_of(world.robots[index(hand.robot)].x, hand.first_dof, hand.dofs);
}

std::vector<double> hand_joints(const World& world, const WorldHand& hand) {
  return part_of(joints_of(world.robots[index(hand.robot)]), hand.first_joint, hand.joints);
}

}  // namespace prehend
