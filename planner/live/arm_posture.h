// The arm of a session, which follows the hand.
#pragma once

#include <string>
#include <vector>

#include "planner/live/hand_posture.h"
#include "planner/live/sweep.h"
#include "sim/scene/reach/reach.h"

namespace prehend {

struct ArmPosture {
  DofValues dofs;           // of all of the platform [rad or m]; those of the hand are not used
  bool holds_hand = false;  // whether the hand is where the arm has it
  std::string problem;      // why it does not, or what of the arm collides; empty: nothing

  bool reached() const { return holds_hand && problem.empty(); }
};

// Where the hand's base is on an arm in this posture, frame of the object.
Pose hand_on_arm(const CompiledArm& arm, const DofValues& dofs);

// The arm as it holds the hand, in the posture nearest to `near` (the sum of the distances of its
// degrees of freedom); postures in which it collides come after all others. Throws Cancelled.
ArmPosture reach_hand(const CompiledArm& arm, const HandPosture& hand, const DofValues& near,
                      const ReachOptions& options, const RunContext& context = {});

// The arm after the hand has gone straight to where it is: on the branch of the inverse kinematics
// that it is on (follow_line). An arm that cannot stays as it is, without the hand. One that did
// not hold the hand before takes hold of it where it can: from where it is, else as reach_hand with
// fewer starts. Collisions are looked for at the end only. Throws Cancelled.
ArmPosture follow_hand(const CompiledArm& arm, const HandPosture& hand, const ArmPosture& before,
                       const ReachOptions& options, const RunContext& context = {});

// The same posture, with what collides in it as its problem. The hand is where the arm has it.
ArmPosture arm_holding(const CompiledArm& arm, const HandPosture& hand, DofValues dofs);

// A posture in which the arm holds the hand, and two bodies that collide there; empty: none do.
struct ArmBranch {
  DofValues dofs;
  std::string link;
  std::string by;
};

// Those of postures_at, nearest to the arm's start first. Throws Cancelled.
std::vector<ArmBranch> arm_branches(const CompiledArm& arm, const HandPosture& hand,
                                    const ReachOptions& options, const RunContext& context = {});

// A motion of the arm with its hand, and why it ended.
struct ArmMotion {
  MotionEnd end = MotionEnd::arrived;
  double share = 1.0;  // of the way that was gone, in 0 .. 1
  DofValues dofs;      // where it ended
  std::string link;    // which touched or overlaps `by`; empty where it arrived
  std::string by;      // the object, an obstacle or another link
};

// Moves the degrees of freedom evenly from one posture to another until a link of the platform
// would touch the object, an obstacle or another link, as sweep() does. The hand's own joints
// rest. Throws Cancelled.
ArmMotion move_arm_to_contact(const CompiledArm& arm, const std::vector<double>& hand_joints,
                              const DofValues& from, const DofValues& to,
                              const TrialOptions& options, const RunContext& context = {});

}  // namespace prehend
