// Motions of the object and of obstacles that end where they would touch something.
#pragma once

#include <string>
#include <vector>

#include "planner/live/sweep.h"
#include "sim/scene/compiled_scene.h"

namespace prehend {

// A robot that stands still while a body is moved.
struct StandingRobot {
  Pose X_WH = Pose::Identity();         // of the hand's base
  std::vector<double> hand_joints;      // [rad or m]
  std::vector<double> platform_joints;  // of all of the platform; empty where it does not count
};

// A motion of a body, and why it ended.
struct BodyMotion {
  MotionEnd end = MotionEnd::arrived;
  double share = 1.0;  // of the way that was gone, in 0 .. 1
  Pose X_WB = Pose::Identity();
  std::string touches;  // the link or body that it touches or overlaps; empty where it arrived
};

// Moves the object or an obstacle along a straight line, turning evenly, until it would touch a
// link of the robot or another body, as sweep() does. `scene` has the meshes, `places` where the
// bodies are. Throws Cancelled.
BodyMotion move_body_to_contact(const CompiledScene& scene, const BodyPlaces& places, BodyId body,
                                const Pose& X_WB_to, const StandingRobot& robot,
                                const TrialOptions& options, const RunContext& context = {});

// Where a body is.
const Pose& place_of(const BodyPlaces& places, BodyId body);
Pose& place_of(BodyPlaces& places, BodyId body);

}  // namespace prehend
