// Whether the arm can bring the hand to a grasp along a straight line from the pre-grasp.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/pose.h"
#include "sim/base/run_context.h"
#include "sim/robot/dof_values.h"
#include "sim/scene/ids.h"
#include "sim/scene/reach/reach_options.h"

namespace prehend {

struct CompiledArm;

// A straight motion of the hand with its own joints at rest. Poses of the hand H in the object's
// frame O.
struct HandLine {
  Pose X_OH_from = Pose::Identity();  // the pre-grasp
  Pose X_OH_to = Pose::Identity();    // the grasp, with the same orientation
  std::vector<double> hand_joints;    // the hand's joint positions [rad or m]
};

// Outcome of an attempt to follow the line.
enum class ReachEnd {
  reached,
  unreachable,  // no posture inside the limits, or none that follows the line without a jump
  blocked,      // Reach::pair collides, in the first posture or along the line
};

// The arm's motion along the line, or why there is none.
struct Reach {
  ReachEnd end = ReachEnd::unreachable;
  std::optional<ArmPair> pair;  // the bodies that collide, if blocked
  // If reached: the platform's degrees of freedom at each step from the pre-grasp to the grasp.
  std::vector<DofValues> line;
};

// All postures found by inverse kinematics that put the hand at X_OH (in the object's frame),
// sorted by their distance from the arm's start posture. Collisions are not checked. Throws
// Cancelled.
std::vector<DofValues> postures_at(const CompiledArm& arm, const Pose& X_OH,
                                   const ReachOptions& options, const RunContext& context = {});

// Tries the postures of the pre-grasp, nearest to the arm's start posture first, until `most` of
// them follow the line to the grasp. A posture does if the inverse kinematics has a continuous
// solution along the line on which the robots do not collide with each other, and no link outside
// the hand collides with the object or the obstacles (collisions of the hand itself are checked by
// the trial). Returns the motions that reach the grasp, or, where none does, one failure: the first
// collision, else unreachable. Throws Cancelled.
std::vector<Reach> find_reaches(const CompiledArm& arm, const HandLine& line, int most,
                                const ReachOptions& options, const RunContext& context = {});

// find_reaches for one motion: the first that reaches the grasp, or the failure.
Reach find_reach(const CompiledArm& arm, const HandLine& line, const ReachOptions& options,
                 const RunContext& context = {});

// The postures along the line that end in the given posture `last`, which has the hand at X_OH_to:
// the line is followed backwards from there. Empty where that meets a joint limit or would have to
// jump to another branch of the inverse kinematics. Collisions are not checked. Throws Cancelled.
std::vector<DofValues> line_ending_in(const CompiledArm& arm, const HandLine& line,
                                      const DofValues& last, const ReachOptions& options,
                                      const RunContext& context = {});

}  // namespace prehend
