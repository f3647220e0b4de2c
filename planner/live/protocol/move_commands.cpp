#include "planner/live/protocol/command.h"
#include "planner/live/protocol/session_json.h"
#include "sim/base/index.h"
#include "sim/base/joined.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/range.h"

// The commands that move the object, obstacles and the arm, as hands drag them.
namespace prehend {
namespace {

ProtocolJson body_motion_json(const BodyMotion& motion, std::string_view pose) {
  ProtocolJson json{{"end", name_of(motion.end)},
                    {"share", motion.share},
                    {"touches", text_or_null(motion.touches)}};
  json[std::string(pose)] = pose_to_json(motion.X_WB);
  return json;
}

ProtocolJson object_move(const CommandScope& scope, const JsonField& request) {
  const Pose X_WO = read_pose(request["X_world_object"]);
  return body_motion_json(scope.session.move_object(X_WO, gesture_of(request)), "X_world_object");
}

ProtocolJson object_remove(const CommandScope& scope, const JsonField& /*request*/) {
  scope.session.edit([](Scene& scene) { remove_object(scene); });
  return state_json(scope.session);
}

ProtocolJson obstacle_move(const CommandScope& scope, const JsonField& request) {
  const Pose X_WB = read_pose(request["X_world_body"]);
  const std::string name = request["name"].text();
  return body_motion_json(scope.session.move_obstacle(name, X_WB, gesture_of(request)),
                          "X_world_body");
}

ProtocolJson arm_branches_of(const CommandScope& scope, const JsonField& /*request*/) {
  const Session& session = scope.session;
  const std::vector<ArmBranch> branches = session.branches();
  ProtocolJson list = ProtocolJson::array();
  for (const ArmBranch& branch : branches) {
    ProtocolJson joints = ProtocolJson::array();
    for (const int d : session.arm()->dofs) joints.push_back(branch.dofs[index(d)]);
    ProtocolJson json{{"joints", joints}, {"collides", !branch.link.empty()}};
    json["link"] = text_or_null(branch.link);
    json["by"] = text_or_null(branch.by);
    list.push_back(std::move(json));
  }
  return {{"branches", list}};
}

ProtocolJson arm_choose(const CommandScope& scope, const JsonField& request) {
  const int branch = request["branch"].integer();
  scope.session.choose_branch(index(branch));
  return {{"arm", arm_json(scope.session)}};
}

std::size_t arm_joint_named(const JsonField& field, const CompiledArm& arm) {
  const std::string name = field.text();
  std::string known;
  for (std::size_t i = 0; i < arm.dofs.size(); ++i) {
    const std::string& own = arm.robot().dofs[index(arm.dofs[i])].name;
    if (own == name) return i;
    add_part(known, own);
  }
  field.fail("must be one of " + known);
}

ProtocolJson arm_joints_set(const CommandScope& scope, const JsonField& request) {
  Session& session = scope.session;
  const CompiledArm& arm = session.require_arm();
  std::vector<double> values;
  for (const int d : arm.dofs) values.push_back(session.state().arm->dofs[index(d)]);
  if (request.has("joints")) {
    if (request.has("joint") || request.has("value")) request.fail("joints, or joint and value");
    values = request["joints"].numbers(values.size());
  } else {
    const std::size_t j = arm_joint_named(request["joint"], arm);
    values[j] = request["value"].number();
  }
  const ArmMotion motion = session.set_arm(values, gesture_of(request));
  ProtocolJson json{{"end", name_of(motion.end)}, {"share", motion.share}};
  json["link"] = text_or_null(motion.link);
  json["by"] = text_or_null(motion.by);
  json["hand"] = hand_json(session);
  json["arm"] = arm_json(session);
  return json;
}

constexpr std::string_view kReplyBodyMotion =
    "`end` (arrived, touched or starts_in_collision, where it did not move), `share` of the way "
    "that was gone, `touches`, the link or body that it touches or overlaps, and the pose where "
    "it is";

std::vector<Command> move_body_commands() {
  return {{"object.move",
           CommandKind::world,
           "Moves the object along a straight line, turning evenly, until it would touch the robot "
           "or an obstacle. The hand stays where it is in the world.",
           {{"X_world_object", FieldType::pose, true, "where to"}, gesture_field()},
           kReplyBodyMotion,
           object_move},
          {"object.remove",
           CommandKind::world,
           "Takes the object away.",
           {},
           "the state, as of `state`",
           object_remove},
          {"obstacle.move",
           CommandKind::world,
           "Moves an obstacle as `object.move` does the object.",
           {{"name", FieldType::text, true, "which"},
            {"X_world_body", FieldType::pose, true, "where to"},
            gesture_field()},
           kReplyBodyMotion,
           obstacle_move}};
}

std::vector<Command> arm_commands() {
  return {
      {"arm.branches",
       CommandKind::query,
       "The postures in which the arm holds the hand where it is, nearest to its start first. Of a "
       "redundant arm some.",
       {},
       "`branches`, each with `joints` as of `state`, whether it `collides`, and `link` and `by`, "
       "two bodies that do",
       arm_branches_of},
      {"arm.choose",
       CommandKind::change,
       "Puts the arm into one of these postures, whatever is between.",
       {{"branch", FieldType::integer, true, "its number in `arm.branches`, from 0", kIndex}},
       "`arm`, as of `state`",
       arm_choose},
      {"arm.joints",
       CommandKind::change,
       "Moves joints of the arm evenly, all or one, and the hand with them. Beyond a limit they "
       "end at it. An arm that does not hold the hand takes it to where it is itself.",
       {{"joints", FieldType::numbers, false, "one value for each [rad or m]", kCoordinate},
        {"joint", FieldType::text, false, "the name of one"},
        {"value", FieldType::number, false, "of `joint` [rad or m]", kCoordinate},
        gesture_field()},
       "`end`, `share`, `link` and `by` as of `hand.move`, `hand` and `arm`",
       arm_joints_set}};
}

}  // namespace

std::optional<int> gesture_of(const JsonField& request) {
  if (!request.has("drag")) return std::nullopt;
  return request["drag"].integer();
}

CommandField gesture_field() {
  return {"drag", FieldType::integer, false,
          "a number that names a gesture: motions of the same thing that follow each other with "
          "the same number are undone together",
          kIndex};
}

std::vector<Command> move_commands() {
  std::vector<Command> all = move_body_commands();
  for (Command& command : arm_commands()) all.push_back(std::move(command));
  return all;
}

}  // namespace prehend
