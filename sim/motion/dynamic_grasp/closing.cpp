#include "sim/motion/dynamic_grasp/closing.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/motion/dynamic_grasp/object_watch.h"

namespace prehend {
namespace {

// What is slower than this part of its closing velocity for so long [s] has stopped.
constexpr double kSlow = 0.05;
constexpr double kStopped = 0.05;
// After this time from the first touch on the next stage begins nevertheless [s]: a finger that
// pushes an object before it may never stop.
constexpr double kLongestTouch = 1.0;

}  // namespace

ClosingState closing_state(const World& world, const WorldHand& hand, const Robot& as_hand) {
  ClosingState state{std::vector<bool>(as_hand.dofs.size(), false), {}};
  const double* rates = world.robots[index(hand.robot)].rate.data() + hand.first_dof;
  state.rates.assign(rates, rates + hand.dofs);
  for (const SolidId& solid : links_on_object(world, hand)) {
    const Link& link = as_hand.links[index(solid.index - hand.first_link)];
    for (const int joint : joints_to(as_hand, link.joint)) {
      state.touches[index(as_hand.joints[index(joint)].dof)] = true;
    }
  }
  return state;
}

Closing::Closing(const Robot& hand, const ClosingStrategy& strategy)
    : waits_(strategy.waits), effort_(strategy.effort), stages_(strategy.first.empty() ? 1 : 2) {
  if (strategy.first.empty() && !waits_ && effort_ == 1.0) stages_ = 0;
  for (const DegreeOfFreedom& dof : hand.dofs) {
    motions_.push_back({.velocity = dof.closing_velocity, .stage = strategy.first.empty() ? 0 : 1});
  }
  for (const int dof : strategy.first) motions_[index(dof)].stage = 0;
}

void Closing::look(const ClosingState& state, double time) {
  if (is_full()) return;
  bool ended = true;
  bool touches = false;
  for (std::size_t d = 0; d < motions_.size(); ++d) {
    Motion& motion = motions_[d];
    if (motion.velocity == 0.0 || motion.stage > stage_) continue;
    motion.touched = motion.touched || state.touches[d];
    const bool slow = std::abs(state.rates[d]) < kSlow * std::abs(motion.velocity);
    motion.still = slow ? motion.still + time : 0.0;
    touches = touches || motion.touched;
    ended = ended && (motion.touched || motion.still >= kStopped);
  }
  if (touches) touched_ += time;
  if (!ended && touched_ < kLongestTouch) return;
  ++stage_;
  touched_ = 0.0;
}

double Closing::effort(std::size_t dof) const {
  const bool stays = waits_ && !is_full() && motions_[dof].touched;
  return stays ? 0.0 : effort_in(stage_, dof);
}

double Closing::effort_in(int stage, std::size_t dof) const {
  const Motion& motion = motions_[dof];
  if (motion.velocity == 0.0) return 0.0;
  if (stage >= stages_) return 1.0;
  return motion.stage > stage ? 0.0 : effort_;
}

}  // namespace prehend
