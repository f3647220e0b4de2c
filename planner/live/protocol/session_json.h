// A session and its parts as JSON, in SI units and radians. Poses X_A_B are those of frame B in
// frame A.
#pragma once

#include "planner/live/protocol/command.h"

namespace prehend {

// A text, or null where it is empty.
ProtocolJson text_or_null(const std::string& text);
// The scene, the hand, the switches, what can be undone, pins, and how many results there are.
ProtocolJson state_json(const Session& session);
// Where the hand is: its pose, degrees of freedom and joints.
ProtocolJson hand_json(const Session& session);
// The arm that carries the hand: its joints, and whether it reaches the hand; null without one.
ProtocolJson arm_json(const Session& session);
// How a motion of the hand ended, and the hand.
ProtocolJson motion_json(const Session& session, const HandMotion& motion);
ProtocolJson contacts_json(const Session& session, const std::vector<GraspContact>& contacts);
// Force [N] and scaled torque [N] of a wrench.
ProtocolJson scaled_wrench_json(const Wrench& wrench);
// A grasp that a plan has found: the trial's pose, posture and epsilon.
ProtocolJson found_json(const Trial& trial);

}  // namespace prehend
