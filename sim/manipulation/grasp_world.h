// The world of a grasp: the object, what stands around it, and the hand that holds it.
#pragma once

#include <memory>

#include "sim/manipulation/test_procedure.h"
#include "sim/motion/dynamic_grasp/scene_world.h"

namespace prehend {

struct CompiledScene;
struct Trial;

// A grasp to be moved: where the object and the hand are, and the values of the hand's degrees of
// freedom and joints, as a trial or a file of grasps has them.
struct GraspPosture {
  Pose X_OH = Pose::Identity();
  std::vector<double> dofs;    // rad or m
  std::vector<double> joints;  // of the hand [rad or m]; empty: as the degrees of freedom say
  // Where the object is by then, in the frame in which it stood (Trial::X_OC).
  Pose X_OC = Pose::Identity();
  ClosingStrategy strategy = {};  // of an open hand
};
GraspPosture posture_of(const Trial& trial);

// Throws InputError where the protocol begins with an object on a support and the scene has none,
// and for a hand with suction cups, whose vacuum is not simulated.
void require_support(const CompiledScene& scene, const TestProcedure& procedure);

struct GraspWorld {
  World world;
  WorldHand hand;
};

// The world of a grasp under a protocol, before anything moves: the object with the mass that the
// protocol or the scene says, the scene's obstacles where the protocol wants a support, the hand
// (a hand_model) with its drives at rest. The protocol's friction, static and kinetic, and torsion
// hold between hand and object. Throws InputError for an object without a positive mass, and as
// require_support.
GraspWorld make_grasp_world(const CompiledScene& scene,
                            const std::shared_ptr<const RobotModel>& hand,
                            const GraspPosture& grasp, const TestProcedure& procedure);

// What a protocol says of a scene's world instead of the scene: gravity, the object's mass,
// friction and torsion between the object and the links of a robot model. Throws InputError for an
// object without a positive mass, and as require_support.
void follow_test_procedure(const CompiledScene& scene, const RobotModel& robot,
                           const TestProcedure& procedure, World& world);

}  // namespace prehend
