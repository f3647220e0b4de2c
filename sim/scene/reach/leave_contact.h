// Whether an arm can move away from what it touches.
#pragma once

#include <optional>
#include <vector>

#include "sim/scene/reach/motion_check.h"

namespace prehend {

struct CompiledArm;

// How far bodies that touch at the start of a motion may move before they are apart: most that a
// point of one moves relative to the other [m].
inline constexpr double kLeaveWithin = 0.02;

// Like first_blocked, for a motion that begins in contact: a pair that is closer at its first
// waypoint than the proof resolves may stay that close at first. It has to be apart at a waypoint
// that it reaches before its bodies have moved by kLeaveWithin, must not begin to touch before, and
// is proven free from that waypoint on. Pairs that are apart at the start are proven free all the
// way. Throws Cancelled.
std::optional<ArmPair> first_blocked_leaving(const CompiledArm& arm,
                                             const std::vector<ArmPair>& pairs,
                                             const JointPath& path, const std::vector<double>& sway,
                                             const MotionCheckOptions& options,
                                             const RunContext& context = {});

}  // namespace prehend
