#include "sim/scene/reach/reach.h"

#include <algorithm>

#include "sim/base/require_settings.h"
#include "sim/robot/inverse_kinematics.h"
#include "sim/scene/compiled_arm.h"
#include "sim/scene/reach/cartesian_line.h"
#include "sim/scene/reach/motion_check.h"

// An arm has several postures for one pose of the hand, the branches of its inverse kinematics, and
// a redundant arm has infinitely many. Along a line the joints can move continuously only within
// one branch. So the postures at the pre-grasp are enumerated once, and from each of them the line
// is followed in short steps, each solved from the posture before. A joint that jumps between two
// steps shows that the solution is on another branch.
namespace prehend {
namespace {

// The target of the inverse kinematics that puts the hand at X_OH.
IkTarget target_at(const CompiledArm& arm, const Pose& X_OH) {
  return {arm.hand_part().joint, arm.hand_part().X_JR, arm.X_BO * X_OH};
}

// The joint positions of the whole platform, the hand's included, at each posture of the line.
JointPath joints_of(const CompiledArm& arm, const std::vector<DofValues>& line,
                    const std::vector<double>& hand_joints) {
  JointPath path;
  path.reserve(line.size());
  for (const DofValues& dofs : line) path.push_back(arm_joints(arm, dofs, hand_joints));
  return path;
}

// The posture at each step of the line; empty where a step has none.
std::vector<DofValues> follow(const CompiledArm& arm, const HandLine& line, const DofValues& first,
                              const ReachOptions& options, const RunContext& context) {
  // The hand keeps its orientation along the line, to the bit.
  Pose X_OH_to = line.X_OH_from;
  X_OH_to.translation() = line.X_OH_to.translation();
  FollowedLine followed = follow_line(arm, line.X_OH_from, X_OH_to, first, options, context);
  if (followed.end != LineEnd::followed) return {};
  return std::move(followed.postures);
}

// Follows the line from one posture at the pre-grasp. The cheapest test comes first: a collision in
// this posture, then the kinematics of the line, then collisions along it.
Reach try_posture(const CompiledArm& arm, const HandLine& line, const DofValues& posture,
                  const ReachOptions& options, const RunContext& context) {
  Reach reach;
  const auto block = [&](const std::optional<ArmPair>& pair) {
    if (!pair) return false;
    reach.end = ReachEnd::blocked;
    reach.pair = pair;
    return true;
  };
  if (block(first_meeting(arm, arm.arm_pairs, arm_joints(arm, posture, line.hand_joints)))) {
    return reach;
  }
  std::vector<DofValues> postures = follow(arm, line, posture, options, context);
  if (postures.empty()) return reach;
  if (block(first_blocked(arm, arm.arm_pairs, joints_of(arm, postures, line.hand_joints),
                          options.motion, context))) {
    return reach;
  }
  reach.end = ReachEnd::reached;
  reach.line = std::move(postures);
  return reach;
}

}  // namespace

std::vector<DofValues> postures_at(const CompiledArm& arm, const Pose& X_OH,
                                   const ReachOptions& options, const RunContext& context) {
  return solve_all(arm.robot(), {target_at(arm, X_OH)}, arm.start, options.kinematics, context);
}

std::vector<Reach> find_reaches(const CompiledArm& arm, const HandLine& line, int most,
                                const ReachOptions& options, const RunContext& context) {
  std::vector<Reach> found;
  Reach failure;
  for (const DofValues& posture : postures_at(arm, line.X_OH_from, options, context)) {
    context.cancellation.check();
    Reach reach = try_posture(arm, line, posture, options, context);
    if (reach.end == ReachEnd::reached) {
      found.push_back(std::move(reach));
      if (found.size() >= index(most)) break;
    } else if (failure.end == ReachEnd::unreachable) {
      // Overwritten until it is a collision, which tells more than an unreachable posture does.
      failure = std::move(reach);
    }
  }
  if (found.empty()) found.push_back(std::move(failure));
  return found;
}

std::vector<DofValues> line_ending_in(const CompiledArm& arm, const HandLine& line,
                                      const DofValues& last, const ReachOptions& options,
                                      const RunContext& context) {
  // Followed from the grasp back to the pre-grasp, so that the given posture is the first one.
  const HandLine back{line.X_OH_to, line.X_OH_from, line.hand_joints};
  std::vector<DofValues> postures = follow(arm, back, last, options, context);
  std::reverse(postures.begin(), postures.end());
  return postures;
}

Reach find_reach(const CompiledArm& arm, const HandLine& line, const ReachOptions& options,
                 const RunContext& context) {
  require_settings(options);
  return find_reaches(arm, line, 1, options, context).front();
}

}  // namespace prehend
