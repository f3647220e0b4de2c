#include <algorithm>
#include <utility>

#include "planner/live/session.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"

// What a session does with the arm that carries its hand.
namespace prehend {

// The arm after a change that moved the hand, the world, or both.
void Session::settle_arm(SessionState& next) const {
  if (!next.world->scene().carrier) {
    next.arm.reset();
  } else if (!next.world->is_ready()) {
    if (!next.arm) return;
    next.arm->holds_hand = false;
    next.arm->problem = next.world->problem();
  } else {
    const CompiledArm& arm = *next.world->compiled().arm;
    const ReachOptions options = trial_options().reach;
    const bool is_known = next.arm && next.arm->dofs.size() == arm.start.size();
    next.arm = is_known ? follow_hand(arm, next.hand, *next.arm, options)
                        : reach_hand(arm, next.hand, arm.start, options);
  }
}

// The arm in a posture that is known to hold the hand; without one as settle_arm.
void Session::hold_arm(SessionState& next, const DofValues& dofs) const {
  if (!next.world->is_ready() || !next.world->compiled().arm || dofs.empty()) {
    settle_arm(next);
    return;
  }
  next.arm = arm_holding(*next.world->compiled().arm, next.hand, dofs);
}

const CompiledArm* Session::arm() const {
  const CompiledScene* parts = state_.world->parts();
  return parts != nullptr && parts->arm ? &*parts->arm : nullptr;
}

const CompiledArm& Session::require_arm() const {
  require(state_.world->scene().carrier.has_value(),
          {.field = "command", .problem = "no arm carries the hand: platform.mount mounts it"});
  return *state_.world->compiled().arm;
}

std::vector<ArmBranch> Session::branches() const {
  return arm_branches(require_arm(), state_.hand, trial_options().reach);
}

void Session::choose_branch(std::size_t branch) {
  const std::vector<ArmBranch> all = branches();
  require(
      branch < all.size(),
      {.field = "branch", .problem = "no branch has this number", .value = std::to_string(branch)});
  SessionState next = state_;
  hold_arm(next, all[branch].dofs);
  push(std::move(next));
}

ArmMotion Session::set_arm(const std::vector<double>& values, Gesture gesture) {
  const CompiledArm& arm = require_arm();
  require(values.size() == arm.dofs.size(),
          {.field = "joints",
           .problem = "must have " + std::to_string(arm.dofs.size()) + " numbers",
           .value = std::to_string(values.size())});
  const DofValues& from = state_.arm->dofs;
  ArmMotion motion;
  motion.dofs = from;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const DegreeOfFreedom& dof = arm.robot().dofs[index(arm.dofs[i])];
    motion.dofs[index(arm.dofs[i])] = std::clamp(values[i], dof.lower, dof.upper);
  }
  if (state_.switches.stop_at_contact) {
    motion = move_arm_to_contact(arm, state_.hand.joints, from, motion.dofs, trial_options());
  }
  SessionState next = state_;
  next.hand.X_OH = hand_on_arm(arm, motion.dofs);
  next.outcome.reset();
  next.grasp.reset();
  hold_arm(next, motion.dofs);
  push(std::move(next), gesture ? std::optional(Dragged{*gesture, "arm"}) : std::nullopt);
  return motion;
}

}  // namespace prehend
