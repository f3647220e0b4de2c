// The world of a grasp: the object, what stands around it, and the hand that holds it.
#pragma once

#include <memory>
#include <optional>

#include "sim/dynamics/world.h"
#include "sim/manipulation/protocol.h"
#include "sim/trial/trial.h"

namespace prehend {

// A grasp to be moved: where the hand is, and the values of its degrees of freedom and joints, as a
// trial or a file of grasps has them.
struct GraspPosture {
  Pose X_OH = Pose::Identity();
  std::vector<double> dofs;    // rad or m
  std::vector<double> joints;  // of the hand [rad or m]; empty: as the degrees of freedom say
};
GraspPosture posture_of(const Trial& trial);

// Indices of what is in the world of a grasp.
inline constexpr int kHeldObject = 0;    // among the bodies; obstacles follow as in the scene
inline constexpr int kGraspingHand = 0;  // among the robots

// The scene's hand as a model, which the worlds of all its grasps share.
std::shared_ptr<const RobotModel> hand_model(const CompiledScene& scene,
                                             const RobotModelOptions& options = {});

// The world of a grasp under a protocol, before anything moves: the object with the mass that the
// protocol or the scene says, the scene's obstacles where the protocol wants a support, the hand
// with its drives at rest. The protocol's friction, static and kinetic, and torsion hold between
// hand and object. Throws InputError for an object without a positive mass.
World make_grasp_world(const CompiledScene& scene, const std::shared_ptr<const RobotModel>& hand,
                       const GraspPosture& grasp, const Protocol& protocol);

// Drives that close every degree of freedom with a closing velocity, up to its largest effort, and
// hold the others where they are.
std::vector<Drive> closing_drives(const RobotModel& hand);

// Drives that take the hand to a posture at its closing velocities and hold it there.
std::vector<Drive> opening_drives(const RobotModel& hand, const Eigen::VectorXd& now,
                                  const std::vector<double>& open);

}  // namespace prehend
