#include "planner/live/arm_posture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/index.h"
#include "sim/robot/inverse_kinematics.h"
#include "sim/scene/reach/cartesian_line.h"
#include "sim/scene/reach/motion_check.h"

namespace prehend {
namespace {

// A hand that is no farther than this from where the arm has it did not move: forward kinematics
// and a change of frames round by less [m, and rad].
constexpr double kSamePlace = 1e-9;

// Random starts of the inverse kinematics while a hand is dragged out of the arm's reach.
constexpr int kRestartsOfDrag = 4;

bool same_place(const Pose& X_A, const Pose& X_B) {
  return (X_A.translation() - X_B.translation()).norm() <= kSamePlace &&
         (X_A.linear() - X_B.linear()).norm() <= kSamePlace;
}

double distance_of(const CompiledArm& arm, const DofValues& a, const DofValues& b) {
  double sum = 0.0;
  for (const int d : arm.dofs) sum += std::abs(a[index(d)] - b[index(d)]);
  return sum;
}

ArmPosture without_hand(const DofValues& dofs, const char* problem) {
  return {dofs, false, problem};
}

// Takes hold of a hand that was out of reach, as fast as a drag needs it: from where the arm is,
// else as reach_hand with fewer starts.
ArmPosture take_hold(const CompiledArm& arm, const HandPosture& hand, const DofValues& from,
                     const ReachOptions& options, const RunContext& context) {
  const IkTarget target{arm.hand_part().joint, arm.hand_part().X_JR, arm.X_BO * hand.X_OH};
  const auto near = solve_near(arm.robot(), {target}, from, options.kinematics);
  if (near) {
    ArmPosture posture = arm_holding(arm, hand, *near);
    if (posture.reached()) return posture;
  }
  ReachOptions quick = options;
  quick.kinematics.restarts = std::min(options.kinematics.restarts, kRestartsOfDrag);
  return reach_hand(arm, hand, from, quick, context);
}

// One motion of the arm, with the way counted in shares of it.
class ArmSweep {
 public:
  ArmSweep(const CompiledArm& arm, std::vector<double> from, std::vector<double> to)
      : arm_(arm), from_(std::move(from)), to_(std::move(to)) {
    for (const auto* list : {&arm.arm_pairs, &arm.hand_pairs}) {
      for (const ArmPair& pair : *list) add(pair);
    }
  }

  SweepEnd run(const TrialOptions& options, const RunContext& context) {
    return sweep(
        swept_, [this](std::size_t pair, double share) { return relative_pose(pair, share); },
        options, context);
  }

  const ArmPair& pair(std::size_t place) const { return *pairs_[place]; }

 private:
  void add(const ArmPair& pair) {
    double speed = 0.0;
    for (std::size_t k = 0; k < pair.joints.size(); ++k) {
      const std::size_t j = index(pair.joints[k]);
      speed += pair.reach[k] * std::abs(to_[j] - from_[j]);
    }
    const CollisionBody* other = nullptr;
    if (const auto* link = std::get_if<LinkId>(&pair.other)) {
      other = &arm_.links[index(*link)];
    } else {
      other = &arm_.body(std::get<BodyId>(pair.other));
    }
    pairs_.push_back(&pair);
    swept_.push_back(
        {other, &arm_.links[index(pair.link)], Vector3::Zero(), Vector3::Zero(), speed});
  }

  Pose relative_pose(std::size_t place, double share) {
    if (share != placed_at_) {
      placed_at_ = share;
      joints_ = from_;
      for (std::size_t j = 0; j < joints_.size(); ++j) joints_[j] += share * (to_[j] - from_[j]);
      arm_link_poses(arm_, joints_, X_BL_);
    }
    const ArmPair& pair = *pairs_[place];
    const auto* link = std::get_if<LinkId>(&pair.other);
    const Pose& X_BF =
        link != nullptr ? X_BL_[index(*link)] : arm_.body(std::get<BodyId>(pair.other)).X_RB;
    return X_BF.inverse() * X_BL_[index(pair.link)];
  }

  const CompiledArm& arm_;
  const std::vector<double> from_;
  const std::vector<double> to_;
  std::vector<const ArmPair*> pairs_;
  std::vector<SweptPair> swept_;
  double placed_at_ = -1.0;  // a share that no way has
  std::vector<double> joints_;
  std::vector<Pose> X_BL_;
};

}  // namespace

Pose hand_on_arm(const CompiledArm& arm, const DofValues& dofs) {
  const PlatformPart& part = arm.hand_part();
  const Pose X_BJ = joint_pose(arm.robot(), part.joint, joint_values(arm.robot(), dofs));
  return arm.X_BO.inverse() * X_BJ * part.X_JR;
}

ArmPosture arm_holding(const CompiledArm& arm, const HandPosture& hand, DofValues dofs) {
  const auto pair = first_meeting(arm, arm.arm_pairs, arm_joints(arm, dofs, hand.joints));
  ArmPosture posture{std::move(dofs), true, ""};
  if (pair) posture.problem = first_name(arm, *pair) + " collides with " + second_name(arm, *pair);
  return posture;
}

ArmPosture reach_hand(const CompiledArm& arm, const HandPosture& hand, const DofValues& near,
                      const ReachOptions& options, const RunContext& context) {
  std::vector<DofValues> all = postures_at(arm, hand.X_OH, options, context);
  if (all.empty()) return without_hand(near, "the arm does not reach the hand");
  std::stable_sort(all.begin(), all.end(), [&](const DofValues& a, const DofValues& b) {
    return distance_of(arm, a, near) < distance_of(arm, b, near);
  });
  for (const DofValues& dofs : all) {
    ArmPosture posture = arm_holding(arm, hand, dofs);
    if (posture.reached()) return posture;
  }
  return arm_holding(arm, hand, all.front());
}

ArmPosture follow_hand(const CompiledArm& arm, const HandPosture& hand, const ArmPosture& before,
                       const ReachOptions& options, const RunContext& context) {
  if (!before.holds_hand) return take_hold(arm, hand, before.dofs, options, context);
  const Pose X_OH_before = hand_on_arm(arm, before.dofs);
  if (same_place(X_OH_before, hand.X_OH)) return arm_holding(arm, hand, before.dofs);
  FollowedLine line = follow_line(arm, X_OH_before, hand.X_OH, before.dofs, options, context);
  if (line.end == LineEnd::jump) {
    return without_hand(before.dofs, "a joint would have to jump; arm.branches lists postures");
  }
  if (line.end == LineEnd::unreachable) {
    return without_hand(before.dofs,
                        "the arm does not follow the hand on the branch that it is on, within its "
                        "limits; arm.branches lists postures");
  }
  return arm_holding(arm, hand, std::move(line.postures.back()));
}

std::vector<ArmBranch> arm_branches(const CompiledArm& arm, const HandPosture& hand,
                                    const ReachOptions& options, const RunContext& context) {
  std::vector<ArmBranch> branches;
  for (DofValues& dofs : postures_at(arm, hand.X_OH, options, context)) {
    const auto pair = first_meeting(arm, arm.arm_pairs, arm_joints(arm, dofs, hand.joints));
    ArmBranch& branch = branches.emplace_back();
    branch.dofs = std::move(dofs);
    if (!pair) continue;
    branch.link = first_name(arm, *pair);
    branch.by = second_name(arm, *pair);
  }
  return branches;
}

ArmMotion move_arm_to_contact(const CompiledArm& arm, const std::vector<double>& hand_joints,
                              const DofValues& from, const DofValues& to,
                              const TrialOptions& options, const RunContext& context) {
  ArmSweep motion(arm, arm_joints(arm, from, hand_joints), arm_joints(arm, to, hand_joints));
  const SweepEnd end = motion.run(options, context);
  if (end.end == MotionEnd::arrived) return {end.end, 1.0, to, "", ""};
  DofValues dofs = from;
  for (std::size_t d = 0; d < dofs.size(); ++d) dofs[d] += end.share * (to[d] - from[d]);
  const ArmPair& pair = motion.pair(end.pair);
  return {end.end, end.share, std::move(dofs), first_name(arm, pair), second_name(arm, pair)};
}

}  // namespace prehend
