#include "planner/files/grasps_file.h"

#include <string>
#include <type_traits>

#include "sim/base/index.h"
#include "sim/scene/json_primitive.h"

namespace prehend {
namespace {

using Json = nlohmann::ordered_json;

Json contact_json(const CompiledScene& scene, const GraspContact& contact) {
  return {{"link", scene.links[index(contact.link)].name},
          {"position", vector_to_json(contact.point.position)},
          {"normal", vector_to_json(contact.point.normal)},
          {"friction", contact.point.friction},
          {"model", contact_model_name(contact.point.model)},
          {"torsion", contact.point.torsion},
          {"gap", contact.gap}};
}

Json primitive_json(const ScoredGrasp& grasp, const PlanResult& result) {
  if (!grasp.primitive) return nullptr;
  return {{"index", *grasp.primitive},
          {"shape", shape_name(result.primitives[index(*grasp.primitive)].shape)},
          {"rule", grasp.rule}};
}

Json blocked_json(const CompiledScene& scene, const Trial& trial) {
  const Blame blocked = blame(scene, trial);
  if (blocked.link.empty()) return nullptr;
  return {{"link", blocked.link}, {"by", blocked.by}};
}

Json path_json(const Trajectory& path) {
  Json segments = Json::array();
  for (const TrajectorySegment& segment : path.segments) {
    segments.push_back({{"name", segment.name}, {"first", segment.first}, {"last", segment.last}});
  }
  return {{"joints", path.joints},
          {"times", path.times},
          {"positions", path.positions},
          {"velocities", path.velocities},
          {"segments", segments}};
}

Json grasp_json(const CompiledScene& scene, const ScoredGrasp& grasp, const PlanResult& result) {
  const Trial& trial = grasp.trial;
  const Candidate& candidate = grasp.candidate;
  const bool stable = trial.outcome == Outcome::stable;
  Json json;
  json["outcome"] = outcome_name(trial.outcome);
  json["epsilon"] = stable ? trial.epsilon.lower : 0.0;
  if (grasp.volume) json["volume"] = *grasp.volume;
  json["force_closure"] = stable;
  json["X_object_hand"] = pose_to_json(trial.X_OH);
  json["X_world_hand"] = pose_to_json(scene.scene.object.X_WO * trial.X_OH);
  if (candidate.preshape) {
    json["preshape"] = scene.scene.hand.hand->preshapes[index(*candidate.preshape)].name;
  } else {
    json["preshape"] = nullptr;
  }
  json["dofs"] = trial.dofs;
  json["joints"] = trial.joints;
  json["contacts"] = Json::array();
  for (const GraspContact& c : trial.contacts) json["contacts"].push_back(contact_json(scene, c));
  json["torque_origin"] = vector_to_json(scene.wrench_frame.torque_origin);
  json["torque_scale"] = scene.wrench_frame.torque_scale;
  json["weakest_wrench"] = {{"force", vector_to_json(trial.epsilon.weakest.head<3>())},
                            {"torque", vector_to_json(trial.epsilon.weakest.tail<3>())}};
  json["primitive"] = primitive_json(grasp, result);
  json["approach"] = {{"direction", vector_to_json(candidate.approach_O)},
                      {"distance", candidate.approach_distance},
                      {"travel", trial.travel},
                      {"back_offs", trial.back_offs},
                      {"turned", trial.turned}};
  json["blocked"] = blocked_json(scene, trial);
  if (!trial.arm_dofs.empty()) {
    json["arm_dofs"] = trial.arm_dofs;
    json["arm_line"] = trial.arm_line;
  }
  if (grasp.path) json["path"] = path_json(*grasp.path);
  return json;
}

template <typename Value>
Json setting_json(const Value& value) {
  if constexpr (std::is_same_v<Value, PathPlanner>) {
    return path_planner_name(value);
  } else {
    return value;
  }
}

// Every setting under its name (sim/base/settings.h).
template <HasSettings Options>
Json settings_json(const Options& options) {
  Json json = Json::object();
  visit_settings(options, [&](const std::string& name, const auto& value) {
    json[name] = setting_json(value);
  });
  return json;
}

Json settings_json(const RunRecord& record) {
  Json json = settings_json(record.options);
  json["contacts"] = record.options.trial.soft_fingers ? "soft" : "hard";
  if (record.options.paths) json["paths"] = settings_json(*record.options.paths);
  return json;
}

Json names_json(const Robot& hand) {
  Json dofs = Json::array();
  for (const DegreeOfFreedom& dof : hand.dofs) dofs.push_back(dof.name);
  Json joints = Json::array();
  for (const Joint& joint : hand.joints) joints.push_back(joint.name);
  return {{"name", hand.name}, {"dofs", dofs}, {"joints", joints}};
}

}  // namespace

std::string grasps_json(const CompiledScene& scene, const PlanResult& result,
                        const RunRecord& record) {
  const GraspableBody& object = scene.scene.object;
  Json json;
  json["format"] = "prehend grasps 1";
  json["scene"] = {{"file", record.scene}, {"unit", record.unit}};
  if (!record.hand.empty()) json["scene"]["hand"] = record.hand;
  json["object"] = {{"name", object.name},
                    {"material", material_name(object.material)},
                    {"mass", object.mass},
                    {"center_of_mass", vector_to_json(object.center_of_mass)},
                    {"X_world_object", pose_to_json(object.X_WO)}};
  json["hand"] = names_json(scene.scene.hand);
  if (scene.arm) {
    json["robot"] = names_json(scene.arm->robot());
    json["robot"]["X_world_robot"] = pose_to_json(scene.arm->X_WB);
  }
  if (scene.has_obstacles()) {
    json["obstacles"] = Json::array();
    for (const PlacedBody& obstacle : scene.obstacles()) {
      json["obstacles"].push_back(obstacle.name);
    }
  }
  json["settings"] = settings_json(record);
  if (result.status != PlanStatus::complete) json["status"] = plan_status_name(result.status);
  if (result.untested > 0) json["untested"] = result.untested;
  json["stages"] = Json::array();
  for (const StageCount& stage : result.stages) {
    json["stages"].push_back({{"name", plan_count_name(stage.what)}, {"count", stage.count}});
  }
  json["outcomes"] = Json::object();
  for (Outcome outcome : kOutcomes) {
    json["outcomes"][std::string(outcome_name(outcome))] =
        result.outcomes[static_cast<std::size_t>(outcome)];
  }
  json["blockers"] = Json::array();
  for (const Blocker& blocker : result.blockers) {
    json["blockers"].push_back({{"outcome", outcome_name(blocker.outcome)},
                                {"link", blocker.link},
                                {"by", blocker.by},
                                {"count", blocker.count}});
  }
  json["primitives"] = Json::array();
  for (const Primitive& primitive : result.primitives) {
    json["primitives"].push_back(primitive_to_json(primitive));
  }
  json["grasps"] = Json::array();
  for (const ScoredGrasp& grasp : result.grasps) {
    json["grasps"].push_back(grasp_json(scene, grasp, result));
  }
  // Names of files need not be text in UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string timings_json(const std::vector<StageTime>& times, const TrialSeconds& trials,
                         int threads) {
  Json json{{"threads", threads}, {"stages", Json::array()}};
  double total = 0.0;
  for (const StageTime& time : times) {
    json["stages"].push_back({{"name", stage_name(time.stage)}, {"seconds", time.seconds}});
    total += time.seconds;
  }
  json["total"] = total;
  json["trials_on_all_threads"] = {
      {"reach", trials.reach}, {"approach", trials.approach}, {"close", trials.close}};
  return json.dump(1) + "\n";
}

}  // namespace prehend
