// The frames of a hand by which the programs of a real robot know it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

struct Robot;
struct Scene;

// A frame F that is fixed to the hand's base.
struct HandFrame {
  std::string name;
  Pose X_HF =
      Pose::Identity();  // in the frame of the hand's base link, in which grasps are planned
};

// Frames of a hand, by the names that the files of its robot give them.
struct EndEffector {
  HandFrame base;                 // of the hand as its maker publishes it
  HandFrame parent;               // of the arm, what the hand is mounted on
  std::optional<HandFrame> tool;  // the tool centre point
};

// Of the hand of a scene. What its file and that of its arm do not say (Robot::frames) is the frame
// of the hand's base link, or that of the arm's last link.
EndEffector end_effector(const Scene& scene);

// What the driver calls the joints of an arm with its hand; their names in the platform where it
// would call two the same.
std::vector<std::string> driver_names(const Robot& platform);

// Where each of these frames is in one of them: a line each, for people who read an exported file.
std::string frames_text(const EndEffector& frames, const HandFrame& reference);

}  // namespace prehend
