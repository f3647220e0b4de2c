#include <algorithm>
#include <cmath>
#include <utility>

#include "planner/live/grasp_score.h"
#include "planner/live/session.h"
#include "sim/base/input_error.h"

// What a session does with time.
namespace prehend {
namespace {

// Surfaces of a moving world may cross by less than they are apart at rest, from where no motion of
// the hand could start: then fingers open by as little as parts them.
HandPosture parted(const CompiledScene& scene, const HandPosture& posture) {
  const Robot& hand = scene.scene.hand;
  for (const double part : {0.0, 1.0, 2.0, 4.0, 8.0}) {
    HandPosture opened = posture;
    for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
      const DegreeOfFreedom& dof = hand.dofs[d];
      if (dof.closing_velocity == 0.0) continue;
      const double way = -std::copysign(part * (slides(hand, d) ? 5e-5 : 1e-3),  // [m or rad]
                                        dof.closing_velocity);
      opened.dofs[d] = std::clamp(opened.dofs[d] + way, dof.lower, dof.upper);
      for (std::size_t j = 0; j < hand.joints.size(); ++j) {
        const Joint& joint = hand.joints[j];
        if (joint.dof != static_cast<int>(d)) continue;
        opened.joints[j] =
            std::clamp(opened.joints[j] + joint.ratio * way, joint.lower, joint.upper);
      }
    }
    if (overlaps_of(scene, opened.X_OH, opened.joints).empty()) return opened;
  }
  return posture;
}

}  // namespace

void Session::require_still() const {
  require(!is_moving(), {.field = "command",
                         .problem = "time is running, which moves the object and the hand: "
                                    "time.stop ends it"});
}

void Session::require_still(const SessionState& next) const {
  const bool changes = next.world != state_.world || !is_same(next.hand, state_.hand) ||
                       next.outcome != state_.outcome;
  if (changes) require_still();
}

MovingWorld& Session::moving() {
  require(is_moving(), {.field = "command", .problem = "time is not running: time.start"});
  return time_->now;
}

const MovingWorld& Session::time() const {
  require(is_moving(), {.field = "command", .problem = "time is not running: time.start"});
  return time_->now;
}

void Session::start_time(const TimeOptions& options) {
  require_still();
  const MovingWorld start(state_.world->compiled(), X_WH(), state_.hand, options);
  time_ = std::make_unique<Time>(Time{start, start});
  ++revision_;
}

void Session::reset_time() {
  // Before time_ is looked at, which is null while time does not run.
  MovingWorld& now = moving();
  now = time_->start;
}

void Session::stop_time(bool keep) {
  const MovingWorld& moved = moving();
  if (keep) {
    require_no_running_plan();
    SessionState next = state_;
    BodyPlaces places = places_of(state_.world->scene());
    places.X_WO = moved.object().X_WB;
    next.world = with_bodies_at(state_.world, places);
    next.hand = parted(next.world->compiled(), moved.posture());
    next.results.reset();
    next.outcome.reset();
    next.grasp.reset();
    settle_arm(next);
    time_.reset();
    push(std::move(next));
    return;
  }
  time_.reset();
  ++revision_;
}

}  // namespace prehend
