#include "planner/protocol/command.h"
#include "planner/protocol/session_json.h"
#include "sim/base/index.h"
#include "sim/json/json_pose.h"

// The commands that improve the grasp in hand, and show how the robot comes to it.
namespace prehend {
namespace {

// Trials that take a second or two; those of an arm take longer.
constexpr int kRefineTrials = 200;
constexpr int kRefineTrialsOfArm = 100;

std::uint64_t seed_of(const JsonField& request) {
  return request.has("seed") ? request["seed"].unsigned_integer() : 1;
}

ProtocolJson grasp_refine(const CommandScope& scope, const JsonField& request) {
  const bool has_arm = scope.session.arm() != nullptr;
  const int usual = has_arm ? kRefineTrialsOfArm : kRefineTrials;
  const int trials = request.has("trials") ? request["trials"].integer() : usual;
  const Refined refined = scope.session.refine(trials, seed_of(request));
  const auto& outcome = scope.session.state().outcome;
  return {{"improved", refined.after > refined.before},
          {"epsilon_before", refined.before},
          {"epsilon", refined.after},
          {"trials", refined.trials},
          {"outcome", outcome_name(outcome.value_or(Outcome::stable))},
          {"hand", hand_json(scope.session)}};
}

// Joints of the platform where there is one, else of the hand.
ProtocolJson joint_names(const Session& session) {
  ProtocolJson names = ProtocolJson::array();
  const Robot& robot =
      session.arm() != nullptr ? session.arm()->robot() : session.state().world->scene().hand;
  for (const Joint& joint : robot.joints) names.push_back(joint.name);
  return names;
}

ProtocolJson path_plan(const CommandScope& scope, const JsonField& request) {
  const Session& session = scope.session;
  const bool lift = !request.has("lift") || request["lift"].boolean();
  const GraspPlayback played = session.playback(seed_of(request), lift);
  ProtocolJson json{{"status", played.found ? "found" : "not_found"}};
  json["problem"] = played.found ? ProtocolJson() : ProtocolJson(played.problem);
  json["joints"] = joint_names(session);
  json["samples"] = ProtocolJson::array();
  json["segments"] = ProtocolJson::array();
  if (!played.found) return json;
  const GraspMotion& motion = played.motion;
  const Pose& X_WO = session.state().world->X_WO();
  for (const MotionFrame& frame : motion.frames) {
    json["samples"].push_back(
        {{"time", frame.time},
         {"joints", frame.arm_joints.empty() ? frame.joints : frame.arm_joints},
         {"X_world_hand", pose_to_json(X_WO * frame.X_OH)},
         {"X_world_object", pose_to_json(X_WO * frame.X_OC)}});
  }
  for (const TrajectorySegment& segment : motion.segments) {
    json["segments"].push_back(
        {{"name", segment.name}, {"first", segment.first}, {"last", segment.last}});
  }
  json["lift"] = lift_end_name(played.lift);
  return json;
}

}  // namespace

std::vector<Command> grasp_commands() {
  return {
      {"grasp.refine",
       CommandKind::change,
       "Improves the grasp in hand by trials of grasps close to it. It stays where none is better.",
       {{"trials", FieldType::integer, false, "how many at most, 2 to 2000; 200, with an arm 100"},
        {"seed", FieldType::integer, false, "of everything random, at least 0; 1"}},
       "`improved`, `epsilon_before` and `epsilon` (lower bounds), how many `trials`, `outcome`, "
       "and `hand`",
       grasp_refine},
      {"path.plan",
       CommandKind::query,
       "How the robot comes to the grasp in hand without a collision: the arm from its start "
       "posture; a free hand straight from the pre-grasp.",
       {{"lift", FieldType::boolean, false,
         "whether an arm then lifts the object and takes it back to its start; true"},
        {"seed", FieldType::integer, false, "of everything random, at least 0; 1"}},
       "`status` (found or not_found, with a `problem`), the names of `joints`, `samples` at most "
       "0.05 s apart, each with `time` [s], `joints` [rad or m], `X_world_hand` and "
       "`X_world_object`, between which joints move evenly, `segments` by `name`, each from its "
       "`first` sample to its `last`, and `lift` (not_asked, complete, lift_unreachable, "
       "lift_blocked or retreat_blocked)",
       path_plan}};
}

}  // namespace prehend
