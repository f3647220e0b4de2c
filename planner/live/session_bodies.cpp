#include <utility>

#include "planner/live/session.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/range.h"

// How a session moves the object and obstacles.
namespace prehend {

void Session::require_place(const Pose& X) {
  for (const double x : X.translation()) require_in(kCoordinate, x, "position");
}

BodyMotion Session::move_body(BodyId body, const Pose& X_WB,
                              const std::optional<Dragged>& dragged) {
  require_no_plan();
  require_place(X_WB);
  BodyPlaces places = places_of(state_.world->scene());
  const Pose X_WH = this->X_WH();
  const CompiledScene* parts = state_.world->parts();
  BodyMotion motion;
  motion.X_WB = X_WB;
  if (state_.switches.stop_at_contact && parts != nullptr) {
    StandingRobot robot{X_WH, state_.hand.joints, {}};
    if (parts->arm && state_.arm && state_.arm->holds_hand) {
      robot.platform_joints = arm_joints(*parts->arm, state_.arm->dofs, state_.hand.joints);
    }
    motion = move_body_to_contact(*parts, places, body, X_WB, robot, trial_options());
  }
  place_of(places, body) = motion.X_WB;
  SessionState next = state_;
  if (body.is_object()) next.hand.X_OH = places.X_WO.inverse() * X_WH;
  next.world = with_bodies_at(state_.world, places);
  next.results.reset();
  next.outcome.reset();
  next.grasp.reset();
  settle_arm(next);
  push(std::move(next), dragged);
  return motion;
}

BodyMotion Session::move_object(const Pose& X_WO, Gesture gesture) {
  require(state_.world->has_object(), {.field = "object", .problem = "there is none"});
  if (!gesture) return move_body(BodyId::object(), X_WO, {});
  return move_body(BodyId::object(), X_WO, Dragged{*gesture, "object"});
}

BodyMotion Session::move_obstacle(const std::string& name, const Pose& X_WB, Gesture gesture) {
  const std::vector<StaticBody>& obstacles = state_.world->scene().obstacles;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (obstacles[i].name != name) continue;
    const BodyId body = BodyId::obstacle(static_cast<int>(i));
    if (!gesture) return move_body(body, X_WB, {});
    return move_body(body, X_WB, Dragged{*gesture, "obstacle " + name});
  }
  throw InputError({.field = "name", .problem = "no obstacle has this name", .value = name});
}

}  // namespace prehend
