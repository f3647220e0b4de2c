// A straight motion of the hand, followed by the arm.
#pragma once

#include <vector>

#include "sim/base/pose.h"
#include "sim/base/run_context.h"
#include "sim/robot/dof_values.h"
#include "sim/scene/reach/reach_options.h"

namespace prehend {

struct CompiledArm;

// How an attempt to follow a line ended.
enum class LineEnd {
  followed,
  unreachable,  // a step has no posture nearby inside the limits: out of reach, or near a singular
                // posture
  jump,         // a joint would move farther in one step than ReachOptions::largest_joint_step
};

struct FollowedLine {
  LineEnd end = LineEnd::unreachable;
  // One at each step, all degrees of freedom of the platform: all of the line where it was
  // followed, else those before step `failed`.
  std::vector<DofValues> postures;
  int failed = -1;  // the step that has none, counted from 0; -1: none
  int steps = 0;    // of the whole line
};

// The postures in which the arm moves the hand along a straight line from X_OH_from to X_OH_to
// (poses of the hand in the object's frame), turning at a constant rate about one axis (slerp).
// Steps are at most ReachOptions::line_step long; a turn counts as the way of a point 0.1 m from
// its axis. `first` has the hand at X_OH_from. Each posture is solved from the one before, so that
// all are on one branch of the inverse kinematics. Collisions are not checked. Throws Cancelled.
FollowedLine follow_line(const CompiledArm& arm, const Pose& X_OH_from, const Pose& X_OH_to,
                         const DofValues& first, const ReachOptions& options,
                         const RunContext& context = {});

// The same for a motion that will be smoothed: where a joint comes to rest at its limit, a smooth
// curve through the postures swings beyond them by a few times 1e-4 rad or m. So the limits are
// narrower by 1e-3, but contain `first`. `arm` is as it was at the end.
FollowedLine follow_line_inside(CompiledArm& arm, const Pose& X_OH_from, const Pose& X_OH_to,
                                const DofValues& first, const ReachOptions& options,
                                const RunContext& context = {});

}  // namespace prehend
