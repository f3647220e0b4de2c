// The world of a scene: its object, what stands around it, and its hand, alone or on the platform
// that carries it.
#pragma once

#include <memory>
#include <vector>

#include "sim/motion/world.h"
#include "sim/scene/ids.h"

namespace prehend {

struct CompiledScene;

// Index of the object among the bodies of a scene's world; obstacles follow as in the scene.
inline constexpr int kObjectBody = 0;
inline constexpr SolidId kObjectSolid = {-1, kObjectBody};

// Where a world has its hand: a robot of its own, or a part of the platform that carries it.
struct WorldHand {
  int robot = 0;                 // among the robots of the world
  int joint = -1;                // its base stands on the frame after this one; -1: on the base
  Pose X_JH = Pose::Identity();  // its base in that frame
  int first_dof = 0;
  int dofs = 0;
  int first_joint = 0;
  int joints = 0;
  int first_link = 0;
  int links = 0;

  bool has(const SolidId& solid) const {
    return solid.robot == robot && solid.index >= first_link && solid.index < first_link + links;
  }
  // Whether the base of the robot is that of the hand, which can be moved freely then.
  bool is_free() const { return joint < 0; }
};

// The scene's hand as a model, which worlds of all its grasps share.
std::shared_ptr<const RobotModel> hand_model(const CompiledScene& scene);

// The platform that carries the scene's hand, and the hand, as one model. The scene has an arm.
std::shared_ptr<const RobotModel> platform_model(const CompiledScene& scene);

// The scene's object with its mass, free, where it stands; with `obstacles` also the obstacles,
// which are fixed; no robot. Friction and soft materials are the scene's, gravity is the world's
// default. Throws InputError for an object without a positive mass.
World make_scene_world(const CompiledScene& scene, bool obstacles);
// The same with these of its obstacles.
World make_scene_world(const CompiledScene& scene, const std::vector<BodyId>& obstacles);

// Adds the hand (a hand_model) with its base at X_WH and all of its drives holding what is.
// `joints` empty: as the degrees of freedom say.
WorldHand add_hand(World& world, const CompiledScene& scene,
                   const std::shared_ptr<const RobotModel>& hand, const Pose& X_WH,
                   const std::vector<double>& dofs, const std::vector<double>& joints = {});

// Adds the platform (a platform_model) of a scene that has an arm, at the values of all of its
// degrees of freedom, its weight compensated, with drives that hold the hand's degrees of freedom.
// `joints`: of the whole platform; empty: as the degrees of freedom say.
WorldHand add_platform(World& world, const CompiledScene& scene,
                       const std::shared_ptr<const RobotModel>& platform,
                       const std::vector<double>& dofs, const std::vector<double>& joints = {});

// The pose of the hand's base.
Pose hand_pose(const World& world, const WorldHand& hand);

// Values of the hand's degrees of freedom, and of its joints [rad or m].
std::vector<double> hand_dofs(const World& world, const WorldHand& hand);
std::vector<double> hand_joints(const World& world, const WorldHand& hand);

}  // namespace prehend
