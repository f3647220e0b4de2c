#include "planner/plan/path/lift_object.h"

#include <algorithm>
#include <utility>

#include "planner/plan/path/blend_transfer.h"
#include "planner/plan/path/motion_lines.h"
#include "planner/plan/path/plan_transfer.h"
#include "sim/base/index.h"
#include "sim/base/require_settings.h"
#include "sim/scene/carried_object.h"
#include "sim/scene/reach/cartesian_line.h"
#include "sim/scene/reach/leave_contact.h"
#include "sim/scene/reach/reach_options.h"
#include "sim/trial/trial.h"

namespace prehend {
std::vector<DofValues> lift_postures(const HeldObject& held, CompiledArm& arm, double height,
                                     const ReachOptions& reach, const RunContext& context) {
  const Vector3 up_O = held.scene.scene.object.X_WO.linear().transpose() * Vector3::UnitZ();
  const Pose& X_OH = held.trial.X_OH;
  FollowedLine line = follow_line_inside(arm, X_OH, translation(height * up_O) * X_OH,
                                         held.arm_dofs, reach, context);
  if (line.end != LineEnd::followed) return {};
  return std::move(line.postures);
}

bool lift_blocked(const CompiledArm& arm, const TimedPath& lift, const MotionCheckOptions& motion,
                  const RunContext& context) {
  const MotionLines all = motion_lines(lift, 0, lift.times.size() - 1);
  std::vector<ArmPair> pairs = arm.arm_pairs;
  pairs.insert(pairs.end(), arm.hand_pairs.begin(), arm.hand_pairs.end());
  return first_blocked_leaving(arm, pairs, all.lines, all.sway, motion, context).has_value();
}

LiftedPath lift_object(const HeldObject& held, const LiftOptions& options,
                       const ReachOptions& reach, const TransferOptions& transfer,
                       const JointLimits& limits, const TimePathOptions& timing,
                       const RunContext& context) {
  require_settings(options);
  LiftedPath path;
  if (options.height == 0.0) return path;
  CompiledArm arm = arm_with_object(held.scene, held.trial.X_OH);
  const std::vector<DofValues> line = lift_postures(held, arm, options.height, reach, context);
  path.end = LiftEnd::lift_unreachable;
  if (line.empty()) return path;
  JointPath postures;
  for (const DofValues& dofs : line) postures.push_back(arm_joints(arm, dofs, held.trial.joints));
  TimedPath lift = time_path(postures, PathKind::smooth, limits, timing);
  path.end = LiftEnd::lift_blocked;
  if (lift_blocked(arm, lift, transfer.motion, context)) return path;
  path.lift = std::move(lift);
  path.end = LiftEnd::complete;
  if (!options.retreat) return path;
  // The hand stays closed, so only the degrees of freedom that carry it go back to the start.
  DofValues home = line.back();
  for (const int d : arm.dofs) home[index(d)] = arm.start[index(d)];
  const std::vector<DofValues> way =
      plan_transfer(arm, {line.back(), home, held.trial.joints}, transfer, context).waypoints;
  if (way.empty()) {
    path.end = LiftEnd::retreat_blocked;
    return path;
  }
  path.retreat = blend_transfer(arm, way, held.trial.joints, limits, transfer, timing, context);
  return path;
}

}  // namespace prehend
