#include "sim/scene/reach/leave_contact.h"

#include <cmath>

#include "sim/base/index.h"
#include "sim/scene/compiled_arm.h"

namespace prehend {
namespace {

// Upper bound of what the joints on the way from one waypoint to the next move a point of one body
// of the pair relative to the other, or with `sway` what they move it beside the path [m].
double motion_of(const ArmPair& pair, const std::vector<double>& joints) {
  double motion = 0.0;
  for (std::size_t k = 0; k < pair.joints.size(); ++k) {
    motion += pair.reach[k] * std::abs(joints[index(pair.joints[k])]);
  }
  return motion;
}

// The waypoint at which a pair that is close at the start is apart; nothing where it is not within
// the allowed way.
std::optional<std::size_t> opens_at(const CompiledArm& arm, const ArmPair& pair,
                                    const JointPath& path, double apart,
                                    const RunContext& context) {
  bool touches = true;
  double moved = 0.0;
  std::vector<Pose> X_BL;
  std::vector<double> step(path.front().size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    context.cancellation.check();
    for (std::size_t j = 0; i > 0 && j < step.size(); ++j) step[j] = path[i][j] - path[i - 1][j];
    moved += motion_of(pair, step);
    if (moved > kLeaveWithin) return std::nullopt;
    arm_link_poses(arm, path[i], X_BL);
    const GapAnswer gap = gap_beyond(arm, pair, X_BL, apart, kMotionGapError);
    if (gap == GapAnswer::larger) return i;
    if (gap == GapAnswer::meets && !touches) return std::nullopt;
    touches = gap == GapAnswer::meets;
  }
  return std::nullopt;
}

}  // namespace

std::optional<ArmPair> first_blocked_leaving(const CompiledArm& arm,
                                             const std::vector<ArmPair>& pairs,
                                             const JointPath& path, const std::vector<double>& sway,
                                             const MotionCheckOptions& options,
                                             const RunContext& context) {
  if (path.empty()) return std::nullopt;
  std::vector<Pose> X_BL;
  arm_link_poses(arm, path.front(), X_BL);
  std::vector<ArmPair> apart;
  for (const ArmPair& pair : pairs) {
    // Twice what first_blocked resolves, so that it does not fail where the pair has just opened.
    const double gap = 2.0 * options.tightest + motion_of(pair, sway);
    if (gap_beyond(arm, pair, X_BL, gap, kMotionGapError) == GapAnswer::larger) {
      apart.push_back(pair);
      continue;
    }
    const auto open = opens_at(arm, pair, path, gap, context);
    if (!open) return pair;
    const JointPath rest(path.begin() + static_cast<std::ptrdiff_t>(*open), path.end());
    if (first_blocked(arm, {pair}, rest, sway, options, context)) return pair;
  }
  return first_blocked(arm, apart, path, sway, options, context);
}

}  // namespace prehend
