#include "planner/plan/path/arm_path.h"

#include <cmath>
#include <utility>

#include "planner/plan/path/blend_transfer.h"
#include "planner/plan/path/motion_lines.h"
#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/number_text.h"
#include "sim/base/require_settings.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/reach/cartesian_line.h"
#include "sim/scene/reach/motion_check.h"

namespace prehend {
namespace {

double distance(const DofValues& a, const DofValues& b) {
  double squares = 0.0;
  for (std::size_t d = 0; d < a.size(); ++d) squares += (a[d] - b[d]) * (a[d] - b[d]);
  return std::sqrt(squares);
}

std::string met(const CompiledArm& arm, const ArmPair& pair) {
  return first_name(arm, pair) + " meets " + second_name(arm, pair);
}

// Joints of the hand where the scene starts.
std::vector<double> start_hand(const CompiledArm& arm, std::size_t joints) {
  const std::vector<double> start = joint_values(arm.robot(), arm.start);
  const auto first = start.begin() + arm.hand_part().first_joint;
  return {first, first + static_cast<std::ptrdiff_t>(joints)};
}

ArmPath failed(ArmPathEnd end, std::string why = {}) {
  ArmPath path;
  path.end = end;
  path.why = std::move(why);
  return path;
}

// The second check of the motion, which ends the planning.
ArmPath judged(const CompiledScene& scene, ArmPath path, const GraspPathOptions& options,
               const RunContext& context) {
  path.check = check_path(scene, path.motion, options.check, context);
  path.end = path.check.ok() ? ArmPathEnd::found : ArmPathEnd::refused;
  path.why = path.check.first_collision;
  return path;
}

ArmPath to_goal(const CompiledScene& scene, const DofValues& goal, const GraspPathOptions& options,
                const RunContext& context) {
  const CompiledArm& arm = *scene.arm;
  const Robot& robot = arm.robot();
  for (std::size_t d = 0; d < goal.size(); ++d) {
    if (within_limits(robot.dofs[d], goal[d])) continue;
    return failed(ArmPathEnd::beyond_limits, robot.dofs[d].name + " at " + shortest_text(goal[d]) +
                                                 ", whose limits are " +
                                                 shortest_text(robot.dofs[d].lower) + " to " +
                                                 shortest_text(robot.dofs[d].upper));
  }
  const std::vector<double> hand = start_hand(arm, scene.scene.hand.joints.size());
  const std::vector<double> joints = arm_joints(arm, goal, hand);
  for (const std::vector<ArmPair>* pairs : {&arm.arm_pairs, &arm.hand_pairs}) {
    if (const auto pair = first_meeting(arm, *pairs, joints)) {
      return failed(ArmPathEnd::goal_collides, met(arm, *pair));
    }
  }
  ArmPath path;
  TransferPath found = plan_transfer(arm, {arm.start, goal, hand}, options.transfer, context);
  if (found.waypoints.empty()) {
    return failed(ArmPathEnd::not_found,
                  found.bottleneck ? "mostly " + met(arm, *found.bottleneck) : "");
  }
  path.waypoints = std::move(found.waypoints);
  for (const Joint& joint : robot.joints) path.motion.joints.push_back(joint.name);
  append(path.motion, "transfer",
         blend_transfer(arm, path.waypoints, hand, joint_limits(robot), options.transfer,
                        options.timing, context));
  return judged(scene, std::move(path), options, context);
}

// The pose of the hand's base in the world.
Pose hand_in_world(const CompiledArm& arm, const DofValues& dofs) {
  std::vector<Pose> X_BJ;
  joint_poses(arm.robot(), joint_values(arm.robot(), dofs), X_BJ);
  const PlatformPart& hand = arm.hand_part();
  return arm.X_WB * (hand.joint < 0 ? hand.X_JR : Pose(X_BJ[index(hand.joint)] * hand.X_JR));
}

}  // namespace

ArmPath plan_arm_path(const CompiledScene& scene, const std::vector<DofValues>& goals,
                      const GraspPathOptions& options, const RunContext& context) {
  require_settings(options);
  ArmPath best;
  for (const DofValues& goal : goals) {
    ArmPath path = to_goal(scene, goal, options, context);
    if (path.end == ArmPathEnd::found) return path;
    if (path.end > best.end) best = std::move(path);
  }
  return best;
}

ArmPath plan_arm_line(const CompiledScene& scene, const Pose& X_WH, const GraspPathOptions& options,
                      const RunContext& context) {
  require_settings(options);
  CompiledArm arm = *scene.arm;
  const Pose X_OW = scene.scene.object.X_WO.inverse();
  FollowedLine line = follow_line_inside(arm, X_OW * hand_in_world(arm, arm.start), X_OW * X_WH,
                                         arm.start, options.reach, context);
  if (line.end != LineEnd::followed) {
    const double part = 100.0 * (line.failed - 1) / line.steps;
    return failed(line.end == LineEnd::jump ? ArmPathEnd::line_jumps : ArmPathEnd::unreachable,
                  formatted("after %.0f %% of the line", part));
  }
  const std::vector<double> hand = start_hand(arm, scene.scene.hand.joints.size());
  JointPath postures;
  for (const DofValues& dofs : line.postures) postures.push_back(arm_joints(arm, dofs, hand));
  const TimedPath timed =
      time_path(postures, PathKind::smooth, joint_limits(arm.robot()), options.timing);
  const MotionLines lines = motion_lines(timed, 0, timed.times.size() - 1);
  for (const std::vector<ArmPair>* pairs : {&arm.arm_pairs, &arm.hand_pairs}) {
    const auto pair =
        first_blocked(arm, *pairs, lines.lines, lines.sway, options.transfer.motion, context);
    if (pair) return failed(ArmPathEnd::line_blocked, met(arm, *pair));
  }
  ArmPath path;
  path.waypoints = std::move(line.postures);
  for (const Joint& joint : arm.robot().joints) path.motion.joints.push_back(joint.name);
  append(path.motion, "line", timed);
  return judged(scene, std::move(path), options, context);
}

double relative_length(const std::vector<DofValues>& waypoints) {
  double sum = 0.0;
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    sum += distance(waypoints[i - 1], waypoints[i]);
  }
  const double straight = distance(waypoints.front(), waypoints.back());
  return straight > 0.0 ? sum / straight : 1.0;
}

}  // namespace prehend
