#include <utility>

#include "planner/live/session.h"
#include "sim/base/input_error.h"

// What a session does with time.
namespace prehend {

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

void Session::reset_time() { moving() = time_->start; }

void Session::stop_time(bool keep) {
  const MovingWorld& moved = moving();
  if (keep) {
    require_no_running_plan();
    SessionState next = state_;
    BodyPlaces places = places_of(state_.world->scene());
    places.X_WO = moved.object().X_WB;
    next.hand = moved.posture();
    next.world = with_bodies_at(state_.world, places);
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
