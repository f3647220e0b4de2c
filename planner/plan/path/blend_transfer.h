// A transfer that runs through its corners instead of stopping there.
#pragma once

#include <vector>

#include "planner/plan/path/plan_transfer.h"
#include "sim/motion/control/time_path.h"

namespace prehend {

struct CompiledArm;
struct Robot;

// Limits of the joints from those of the degrees of freedom that drive them.
JointLimits joint_limits(const Robot& robot);

// The timed motion along straight lines in joint space, free of collision as they are: `waypoints`
// are degrees of freedom of the platform, `hand_joints` the hand's joints all the way. Each corner
// is rounded off (time_blended) as far as TransferOptions::corner_deviation allows and as is proven
// free of collision with the arm's pairs of bodies; where no blend is, the motion stops at the
// corner. The proof is of the timed motion itself, between its samples too. Throws Cancelled.
TimedPath blend_transfer(const CompiledArm& arm, const std::vector<DofValues>& waypoints,
                         const std::vector<double>& hand_joints, const JointLimits& limits,
                         const TransferOptions& options, const TimePathOptions& timing,
                         const RunContext& context = {});

}  // namespace prehend
