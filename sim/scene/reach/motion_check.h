// Whether an arm can move along a path of postures without touching anything.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/scene/ids.h"
#include "sim/scene/reach/reach_options.h"

namespace prehend {

struct CompiledArm;

// Waypoints of a motion, joined by straight lines in joint space. Each has one value for each joint
// of the platform [rad or m].
using JointPath = std::vector<std::vector<double>>;

// Relative error by which the gap of a pair may be underestimated. A larger one makes each distance
// query faster, but divides the motion into more stretches.
inline constexpr double kMotionGapError = 0.5;

// Continuous collision check: a pair that could not be proved to stay apart along the path (the
// first one found), or none if the whole motion is free, between the waypoints too. If the gap of a
// pair in the middle of a stretch is larger than any point can move from there to its ends, the
// pair is free on the whole stretch; else the stretch is halved (Schwarzer, Saha and Latombe 2005,
// "Adaptive dynamic collision checking"). Only surfaces are compared here: that no body lies
// entirely inside another must be checked beforehand, at one posture of the path (first_meeting).
// Throws Cancelled.
std::optional<ArmPair> first_blocked(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                     const JointPath& path, const MotionCheckOptions& options = {},
                                     const RunContext& context = {});

// The same for a motion that leaves the lines between its waypoints, each joint by no more than
// `sway` says (one number a joint [rad or m]).
std::optional<ArmPair> first_blocked(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                     const JointPath& path, const std::vector<double>& sway,
                                     const MotionCheckOptions& options,
                                     const RunContext& context = {});

// The first of the pairs whose bodies collide in a posture (one value for each joint of the
// platform): their surfaces intersect, or one body lies inside the other.
std::optional<ArmPair> first_meeting(const CompiledArm& arm, const std::vector<ArmPair>& pairs,
                                     const std::vector<double>& joints);

}  // namespace prehend
