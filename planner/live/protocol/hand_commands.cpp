#include "planner/live/protocol/command.h"
#include "planner/live/protocol/session_json.h"
#include "sim/base/index.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/range.h"

// The commands that move the hand, and those that undo.
namespace prehend {
namespace {

// How far an approach looks for something to touch, where nobody says [m].
constexpr double kApproach = 0.5;

ProtocolJson hand_move(const CommandScope& scope, const JsonField& request) {
  const bool in_world = request.has("X_world_hand");
  if (in_world == request.has("X_object_hand")) {
    request.fail("needs one of X_world_hand and X_object_hand");
  }
  Session& session = scope.session;
  const Pose X_OH =
      in_world ? Pose(session.state().world->X_WO().inverse() * read_pose(request["X_world_hand"]))
               : read_pose(request["X_object_hand"]);
  const HandMotion motion = session.move_hand(X_OH, gesture_of(request));
  return motion_json(session, motion);
}

// The place of a degree of freedom by its name.
std::size_t dof_named(const JsonField& field, const Robot& hand) {
  const std::string name = field.text();
  std::string known;
  for (std::size_t d = 0; d < hand.dofs.size(); ++d) {
    if (hand.dofs[d].name == name) return d;
    add_part(known, hand.dofs[d].name);
  }
  field.fail("must be one of " + known);
}

ProtocolJson hand_dofs(const CommandScope& scope, const JsonField& request) {
  Session& session = scope.session;
  std::vector<double> dofs = session.state().hand.dofs;
  if (request.has("dofs")) {
    if (request.has("dof") || request.has("value")) request.fail("dofs, or dof and value");
    dofs = request["dofs"].numbers(dofs.size());
  } else {
    const std::size_t d = dof_named(request["dof"], session.state().world->scene().hand);
    dofs[d] = request["value"].number();
  }
  const HandMotion motion = session.set_dofs(dofs, gesture_of(request));
  return motion_json(session, motion);
}

ProtocolJson hand_preshape(const CommandScope& scope, const JsonField& request) {
  const HandMotion motion = scope.session.take_preshape(request["preshape"].text());
  return motion_json(scope.session, motion);
}

ProtocolJson hand_open(const CommandScope& scope, const JsonField& /*request*/) {
  const HandMotion motion = scope.session.open_hand();
  return motion_json(scope.session, motion);
}

ProtocolJson hand_back_off(const CommandScope& scope, const JsonField& request) {
  const HandMotion motion =
      scope.session.back_off(request.number_or("distance", TrialOptions().back_off_step));
  return motion_json(scope.session, motion);
}

ProtocolJson hand_approach(const CommandScope& scope, const JsonField& request) {
  const HandMotion motion = scope.session.approach(request.number_or("distance", kApproach));
  return motion_json(scope.session, motion);
}

ProtocolJson auto_grasp(const CommandScope& scope, const JsonField& /*request*/) {
  const Session& session = scope.session;
  const Trial trial = scope.session.auto_grasp();
  const CollisionNames colliding = collision_of(session.state().world->compiled(), trial);
  ProtocolJson json{{"outcome", name_of(trial.outcome)},
                    {"epsilon",
                     {{"lower", trial.epsilon.lower},
                      {"upper", trial.epsilon.upper},
                      {"status", name_of(trial.epsilon.status)}}},
                    {"contacts", contacts_json(session, trial.contacts)},
                    {"hand", hand_json(session)}};
  json["blocked"] = colliding.by.empty()
                        ? ProtocolJson()
                        : ProtocolJson{{"link", colliding.link}, {"by", colliding.by}};
  return json;
}

ProtocolJson switches_set(const CommandScope& scope, const JsonField& request) {
  Switches switches = scope.session.state().switches;
  if (request.has("stop_at_contact")) {
    switches.stop_at_contact = request["stop_at_contact"].boolean();
  }
  if (request.has("soft_fingers")) switches.soft_fingers = request["soft_fingers"].boolean();
  scope.session.set_switches(switches);
  return state_json(scope.session);
}

ProtocolJson undo(const CommandScope& scope, const JsonField& /*request*/) {
  const bool done = scope.session.undo();
  return {{"done", done}, {"state", state_json(scope.session)}};
}

ProtocolJson redo(const CommandScope& scope, const JsonField& /*request*/) {
  const bool done = scope.session.redo();
  return {{"done", done}, {"state", state_json(scope.session)}};
}

constexpr std::string_view kReplyMotion =
    "`end` (arrived, touched or starts_in_collision, where the hand did not move), `share` of the "
    "way that was gone, `link` and `by`, the bodies that touch or overlap, and `hand`";

std::vector<Command> motion_commands() {
  return {
      {"hand.move",
       CommandKind::change,
       "Moves the hand's base along a straight line, turning evenly. One of the poses is needed.",
       {{"X_world_hand", FieldType::pose, false, "where to, in the world"},
        {"X_object_hand", FieldType::pose, false, "where to, in the frame of the object"},
        gesture_field()},
       kReplyMotion,
       hand_move},
      {"hand.dofs",
       CommandKind::change,
       "Moves degrees of freedom, all or one. Beyond a limit they end at it; joints follow.",
       {{"dofs", FieldType::numbers, false, "one value for each [rad or m]", kCoordinate},
        {"dof", FieldType::text, false, "the name of one"},
        {"value", FieldType::number, false, "of `dof` [rad or m]", kCoordinate},
        gesture_field()},
       kReplyMotion,
       hand_dofs},
      {"hand.preshape",
       CommandKind::change,
       "Moves the degrees of freedom to those of a preshape.",
       {{"preshape", FieldType::text, true, "its name"}},
       kReplyMotion,
       hand_preshape},
      {"hand.open",
       CommandKind::change,
       "Moves each degree of freedom that closes to its other limit.",
       {},
       kReplyMotion,
       hand_open},
      {"hand.back_off",
       CommandKind::change,
       "Moves the hand back, against its approach direction.",
       {{"distance", FieldType::number, false, "m, at least 0; 0.008", kDistance}},
       kReplyMotion,
       hand_back_off},
      {"hand.approach",
       CommandKind::change,
       "Moves the hand along its approach direction until it touches the object or an obstacle. "
       "It stays where it is when there is nothing to touch.",
       {{"distance", FieldType::number, false, "how far at most [m]; 0.5", kDistance}},
       kReplyMotion,
       hand_approach}};
}

}  // namespace

std::vector<Command> hand_commands() {
  std::vector<Command> all = motion_commands();
  all.push_back({"hand.auto_grasp",
                 CommandKind::change,
                 "Closes the hand where it is, as `evaluate` does with a given grasp.",
                 {},
                 "`outcome`, the bracket of `epsilon`, `contacts` as of `contacts`, `hand`, and "
                 "`blocked`, the bodies that overlap, or null",
                 auto_grasp});
  all.push_back({"switches.set",
                 CommandKind::change,
                 "Sets the switches that are given.",
                 {{"stop_at_contact", FieldType::boolean, false,
                   "whether motions of the hand end where it touches; on at first"},
                  {"soft_fingers", FieldType::boolean, false,
                   "whether compliant links pass on torque about the normal; on at first"}},
                 "the state, as of `state`",
                 switches_set});
  all.push_back({"undo",
                 CommandKind::world,
                 "Takes back the last change.",
                 {},
                 "`done`, false where there was nothing, and `state`",
                 undo});
  all.push_back({"redo",
                 CommandKind::world,
                 "Makes the change again that was taken back last.",
                 {},
                 "`done`, false where there was nothing, and `state`",
                 redo});
  return all;
}

}  // namespace prehend
