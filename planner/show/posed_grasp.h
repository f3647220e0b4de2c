// Input of all pictures: hand, contacts and arm at one moment.
#pragma once

#include <string>
#include <vector>

#include "sim/quality/contact_map.h"
#include "sim/trial/trial.h"

namespace prehend {

struct CompiledScene;
struct MotionFrame;
struct ScoredGrasp;

// A hand where it is, with what it touches.
struct PosedGrasp {
  Pose X_OH = Pose::Identity();
  std::vector<double> joints;           // of the hand [rad or m]
  std::vector<GraspContact> contacts;   // each drawn as its friction cone
  Wrench weakest = Wrench::Zero();      // drawn from the centre of mass; zero: not drawn
  std::string title;                    // lines under the picture
  std::vector<double> arm_joints = {};  // of the whole platform; empty: no arm is drawn
  Pose X_OC = Pose::Identity();         // the object as the hand carries it (MotionFrame)
};

// A grasp that was tried: the hand closed, and where the scene has an arm and the trial found its
// posture, the arm that holds the hand there.
PosedGrasp posed_grasp(const CompiledScene& scene, const ScoredGrasp& grasp,
                       const std::string& title = "");

// The hand, and with it the arm, at a moment of a motion; nothing touches yet.
PosedGrasp posed_at(const MotionFrame& frame);

}  // namespace prehend
