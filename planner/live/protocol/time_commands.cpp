#include <algorithm>
#include <optional>

#include "planner/live/protocol/command.h"
#include "planner/live/protocol/graspit_text.h"
#include "planner/live/protocol/session_json.h"
#include "sim/base/index.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/range.h"
#include "sim/motion/solids.h"

// The commands of a scene in motion.
namespace prehend {
namespace {

const std::string& solid_name(const World& world, const SolidId& id) {
  if (id.robot < 0) return world.bodies[index(id.index)].name;
  return world.robots[index(id.robot)].model->robot.links[index(id.index)].name;
}

// Where everything is, and how it moves.
ProtocolJson moment_json(const MovingWorld& moving) {
  const World& world = moving.world();
  const WorldRobot& robot = world.robots[index(moving.hand().robot)];
  const HandPosture posture = moving.posture();
  const RigidMotion& object = moving.object();
  const Eigen::Index dofs = robot.model->dofs();
  return {{"time", moving.time()},
          {"X_world_object", pose_to_json(object.X_WB)},
          {"X_world_hand", pose_to_json(hand_pose(world, moving.hand()))},
          {"dofs", posture.dofs},
          {"joints", posture.joints},
          {"rates", std::vector<double>(robot.rate.data(), robot.rate.data() + dofs)},
          {"velocity", vector_to_json(object.linear)},
          {"angular_velocity", vector_to_json(object.angular)}};
}

// The object first, where it is one of the two, so that forces are those on it.
ProtocolJson contact_json(const World& world, const WorldContact& contact) {
  const bool turn = contact.b == kObjectSolid;
  const double sign = turn ? -1.0 : 1.0;
  const double rate = sign / world.last_step;
  return {{"bodies",
           {solid_name(world, turn ? contact.b : contact.a),
            solid_name(world, turn ? contact.a : contact.b)}},
          {"position_world", vector_to_json(contact.position_W)},
          {"normal_world", vector_to_json(sign * contact.normal_W)},
          {"force_world", vector_to_json(rate * contact.impulse_W)},
          {"torque", contact.spin_impulse / world.last_step},
          {"gap", contact.gap}};
}

ProtocolJson time_start(const CommandScope& scope, const JsonField& request) {
  TimeOptions options;
  if (request.has("gravity")) options.gravity = request["gravity"].boolean();
  options.step = request.number_or("step", options.step);
  scope.session.start_time(options);
  return moment_json(scope.session.time());
}

ProtocolJson time_step(const CommandScope& scope, const JsonField& request) {
  MovingWorld& moving = scope.session.moving();
  const StepOutcome outcome = moving.advance(request["seconds"].number());
  ProtocolJson json = moment_json(moving);
  json["outcome"] = name_of(outcome);
  return json;
}

ProtocolJson time_state(const CommandScope& scope, const JsonField& /*request*/) {
  return moment_json(scope.session.time());
}

ProtocolJson time_contacts(const CommandScope& scope, const JsonField& /*request*/) {
  const MovingWorld& moving = scope.session.time();
  ProtocolJson list = ProtocolJson::array();
  for (const WorldContact& contact : moving.world().contacts) {
    list.push_back(contact_json(moving.world(), contact));
  }
  return {{"time", moving.time()}, {"contacts", std::move(list)}};
}

ProtocolJson drive_json(const DofDrive& drive) {
  if (drive.target) return {{"target", *drive.target}};
  if (drive.effort) return {{"effort", *drive.effort}};
  return nullptr;
}

std::optional<double> number_or_null(const JsonField& request, std::string_view name) {
  if (!request.has(name)) return std::nullopt;
  return request[name].number();
}

ProtocolJson time_drive(const CommandScope& scope, const JsonField& request) {
  MovingWorld& moving = scope.session.moving();
  const std::vector<DegreeOfFreedom>& dofs = scope.session.state().world->scene().hand.dofs;
  const DofDrive drive{number_or_null(request, "target"), number_or_null(request, "effort")};
  if (drive.target && drive.effort) request.fail("target, or effort, or neither");
  const std::string name = request.text_or("dof", "");
  bool is_there = name.empty();
  for (const DegreeOfFreedom& dof : dofs) is_there = is_there || dof.name == name;
  if (!is_there) request["dof"].fail("the hand has no such degree of freedom");
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    if (name.empty() || dofs[d].name == name) moving.drive(d, drive);
  }
  ProtocolJson drives = ProtocolJson::array();
  for (std::size_t d = 0; d < dofs.size(); ++d) {
    drives.push_back({{"dof", dofs[d].name}, {"drive", drive_json(moving.drives()[d])}});
  }
  return {{"drives", std::move(drives)}};
}

ProtocolJson time_pull(const CommandScope& scope, const JsonField& request) {
  MovingWorld& moving = scope.session.moving();
  const bool pulls = request.has("stiffness");
  if (pulls != request.has("point_object") || pulls != request.has("to_world")) {
    request.fail("needs all of point_object, to_world and stiffness, or none");
  }
  if (!pulls) {
    moving.pull(std::nullopt);
  } else {
    moving.pull(ObjectPull{request["point_object"].vector3(), request["to_world"].vector3(),
                           request["stiffness"].number()});
  }
  return {{"pulls", pulls}};
}

ProtocolJson time_reset(const CommandScope& scope, const JsonField& /*request*/) {
  scope.session.reset_time();
  return moment_json(scope.session.time());
}

ProtocolJson time_stop(const CommandScope& scope, const JsonField& request) {
  scope.session.stop_time(request.has("keep") && request["keep"].boolean());
  return state_json(scope.session);
}

ProtocolJson graspit(const CommandScope& scope, const JsonField& request) {
  return {{"lines", graspit_reply(scope.session, request["line"].text())}};
}

constexpr std::string_view kReplyMoment =
    "`time` since the start [s], `X_world_object`, `X_world_hand`, the hand's `dofs`, `joints` and "
    "`rates` of the degrees of freedom [rad/s or m/s], and the object's `velocity`, of its centre "
    "of mass, and `angular_velocity`, in world axes";

std::vector<Command> acting_commands() {
  return {
      {"time.drive",
       CommandKind::change,
       "Drives a degree of freedom of the hand: to a target, which it reaches at its closing "
       "speed and holds, or with an effort. With neither it is held where it is.",
       {{"dof", FieldType::text, false, "its name; left out: all of them"},
        {"target", FieldType::number, false, "rad or m; beyond a limit it is that", kCoordinate},
        {"effort", FieldType::number, false, "N m or N; beyond the largest that it has it is that",
         kLoad}},
       "`drives`, for each `dof` its `drive`: `target` or `effort`, or null where it is held",
       time_drive},
      {"time.pull",
       CommandKind::change,
       "Pulls at the object with a damped spring of no length, or, without fields, no more.",
       {{"point_object", FieldType::vector3, false, "where it is held, in its frame [m]",
         kCoordinate},
        {"to_world", FieldType::vector3, false, "where to, in the world [m]", kCoordinate},
        {"stiffness", FieldType::number, false,
         "N/m, at least 0; at most what steps of this length can follow", kGain}},
       "`pulls`, whether it does now",
       time_pull},
      {"time.reset",
       CommandKind::change,
       "Goes back to the start; the hand is held again, and nothing pulls.",
       {},
       kReplyMoment,
       time_reset},
      {"time.stop",
       CommandKind::change,
       "Ends time.",
       {{"keep", FieldType::boolean, false,
         "whether the object and the hand stay where they are by now, one step of undo; false: "
         "they are where they were at the start. True is refused while a plan runs."}},
       "the state, as of `state`",
       time_stop}};
}

}  // namespace

std::vector<Command> time_commands() {
  std::vector<Command> all = {
      {"time.start",
       CommandKind::change,
       "Makes a moving world of the scene as it is: the object is free, obstacles and the hand's "
       "base are fixed, the hand is held by its drives. A platform does not take part.",
       {{"gravity", FieldType::boolean, false, "whether 9.81 m/s² pull down; true"},
        {"step", FieldType::number, false,
         "longest step of the simulation, 0.0005 to 0.02 s; 0.0025", kLiveStep}},
       kReplyMoment,
       time_start},
      {"time.step",
       CommandKind::change,
       "Moves on.",
       {{"seconds", FieldType::number, true, "above 0, at most 1", kLiveAdvance}},
       "as `time.start`, and `outcome`, the worst of its steps: `moved`, `not_converged` (forces "
       "of "
       "contact are not exact), `blocked` or `not_finite`; the last two end it early",
       time_step},
      {"time.state", CommandKind::query, "Where everything is now.", {}, kReplyMoment, time_state},
      {"time.contacts",
       CommandKind::query,
       "Contacts of the last step.",
       {},
       "`time`, and `contacts`, each with the names of the two `bodies` (the object first, where "
       "it "
       "is one of them), `position_world`, `normal_world` into the first, `force_world` on the "
       "first [N], `torque` about the normal [N m] and the `gap` before the step [m]",
       time_contacts}};
  for (Command& command : acting_commands()) all.push_back(std::move(command));
  all.push_back({"graspit",
                 CommandKind::change,
                 "Carries out a line of GraspIt!'s text protocol (graspit-protocol.md).",
                 {{"line", FieldType::text, true, "its words"}},
                 "`lines`, those that a client of that protocol gets, errors among them",
                 graspit});
  return all;
}

}  // namespace prehend
