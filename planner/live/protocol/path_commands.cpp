#include "planner/live/protocol/command.h"
#include "planner/live/protocol/session_json.h"
#include "sim/base/index.h"
#include "sim/base/json/json_pose.h"
#include "sim/base/range.h"

// The commands that find and show how the robot comes to a grasp.
namespace prehend {
namespace {

ProtocolJson path_plan(const CommandScope& scope, const JsonField& request) {
  const bool lift = !request.has("lift") || request["lift"].boolean();
  const std::uint64_t seed = request.has("seed") ? request["seed"].unsigned_integer() : 1;
  scope.session.start_path(seed, lift, scope.listener ? scope.listener() : PlanListener{});
  return {{"started", true}};
}

ProtocolJson path_cancel(const CommandScope& scope, const JsonField& /*request*/) {
  const std::optional<Cancellation> running = scope.session.path_cancellation();
  if (running && scope.cancels) running->request();
  return {{"cancelled", running.has_value()}};
}

// Joints of the platform where there is one, else of the hand.
ProtocolJson joint_names(const EditedScene& world) {
  ProtocolJson names = ProtocolJson::array();
  const CompiledScene& scene = world.compiled();
  const Robot& robot = scene.arm ? scene.arm->robot() : scene.scene.hand;
  for (const Joint& joint : robot.joints) names.push_back(joint.name);
  return names;
}

ProtocolJson path_json(const PlannedPath& path) {
  const GraspPlayback& played = path.playback;
  ProtocolJson json{{"status", name_of(played.found ? PathEnd::found : PathEnd::not_found)}};
  json["problem"] = played.found ? ProtocolJson() : ProtocolJson(played.problem);
  json["joints"] = joint_names(*path.world);
  json["samples"] = ProtocolJson::array();
  json["segments"] = ProtocolJson::array();
  if (!played.found) return json;
  const Pose& X_WO = path.world->X_WO();
  for (const MotionFrame& frame : played.motion.frames) {
    json["samples"].push_back(
        {{"time", frame.time},
         {"joints", frame.arm_joints.empty() ? frame.joints : frame.arm_joints},
         {"X_world_hand", pose_to_json(X_WO * frame.X_OH)},
         {"X_world_object", pose_to_json(X_WO * frame.X_OC)}});
  }
  for (const TrajectorySegment& segment : played.motion.segments) {
    json["segments"].push_back(
        {{"name", segment.name}, {"first", segment.first}, {"last", segment.last}});
  }
  json["lift"] = name_of(played.lift);
  return json;
}

ProtocolJson path_result(const CommandScope& scope, const JsonField& request) {
  if (!request.has("grasp")) return path_json(scope.session.path());
  const int grasp = request["grasp"].integer();
  return path_json(scope.session.path_of(index(grasp)));
}

}  // namespace

std::vector<Command> path_commands() {
  return {
      {"path.plan",
       CommandKind::query,
       "Begins to look for how the robot comes to the grasp in hand without a collision: the arm "
       "from its start posture; a free hand straight from the pre-grasp.",
       {{"lift", FieldType::boolean, false,
         "whether an arm then lifts the object and takes it back to its start; true"},
        {"seed", FieldType::integer, false, "of everything random, at least 0; 1", kIndex}},
       "`started`",
       path_plan},
      {"path.cancel",
       CommandKind::query,
       "Ends the search for a path at once, without one; the event `path` tells when.",
       {},
       "`cancelled`, false where none is looked for",
       path_cancel},
      {"path.result",
       CommandKind::query,
       "What `path.plan` has found, as long as neither the hand nor the scene have changed since; "
       "or "
       "the path of a result of a plan with `paths`.",
       {{"grasp", FieldType::integer, false,
         "the number of the result, from 0; without it, that of `path.plan`", kIndex}},
       "`status` (found or not_found, with a `problem`), the names of `joints`, `samples` at most "
       "0.05 s apart, each with `time` [s], `joints` [rad or m], `X_world_hand` and "
       "`X_world_object`, between which joints move evenly, `segments` by `name`, each from its "
       "`first` sample to its `last`, and `lift` (not_asked, complete, lift_unreachable, "
       "lift_blocked or retreat_blocked)",
       path_result}};
}

}  // namespace prehend
