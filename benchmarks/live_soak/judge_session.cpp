#include "benchmarks/live_soak/judge_session.h"

#include <cmath>

#include "planner/plan/plan.h"
#include "sim/base/json/json_pose.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/scene_file.h"

namespace prehend::live_soak {
namespace {

// Two computations of the same epsilon differ by rounding of the pose that a message has.
constexpr double kSameEpsilon = 1e-9;

Json state_of(const Ask& ask) { return result_of(ask, {{"command", "state"}}); }

std::string scene_text(const Ask& ask) {
  return result_of(ask, {{"command", "scene.text"}}).value("text", "");
}

// The hand is moved by `shift_O` first.
Trial evaluated(const Json& state, const std::string& scene_text,
                const Vector3& shift_O = Vector3::Zero()) {
  const JsonFile file("scene", scene_text);
  const JsonFile posed("state", state["hand"].dump());
  const CompiledScene scene = compile(read_scene(file));
  Candidate candidate;
  candidate.X_OH = read_pose(posed.root()["X_object_hand"]);
  candidate.X_OH.pretranslate(shift_O);
  candidate.approach_O = candidate.X_OH.linear() * scene.scene.hand.hand->approach;
  for (const Json& dof : state["hand"]["dofs"]) candidate.dofs.push_back(dof["value"]);
  candidate.joints = state["hand"]["joints"].get<std::vector<double>>();
  EvaluateOptions options;
  options.trial.contacts =
      state["switches"]["soft_fingers"] ? ContactKind::soft : ContactKind::hard;
  return evaluate(scene, {candidate}, options).grasps.at(0).trial;
}

bool is_same(const Json& grasp, const Trial& trial) {
  return grasp["outcome"] == name_of(trial.outcome) &&
         std::abs(grasp["epsilon"]["lower"].get<double>() - trial.epsilon.lower) <= kSameEpsilon;
}

// Whether a hand that is moved by rounding errors closes like this.
bool is_same_nearby(const Json& grasp, const Json& state, const std::string& scene_text) {
  for (const double length : {1e-15, 1e-14, 1e-13, 1e-12}) {
    for (int k = 0; k < 6; ++k) {
      const Vector3 shift_O = (k < 3 ? length : -length) * Vector3::Unit(k % 3);
      if (is_same(grasp, evaluated(state, scene_text, shift_O))) return true;
    }
  }
  return false;
}

bool is_ready(const Json& state) {
  return state["object"].is_object() && state["problem"].is_null() && state["platform"].is_null() &&
         state["time"].is_null();
}

}  // namespace

Json result_of(const Ask& ask, const Json& request) {
  return ask(request).value("result", Json::object());
}

JudgedChange judge_change(const Ask& ask, const Ask& other, const std::function<Json()>& make) {
  Json before = state_of(ask);
  const std::string scene = scene_text(ask);
  const bool is_refused = make()["ok"] != true;
  JudgedChange judged{ChangeEnd::no_step, state_of(ask), {}};
  const Json& after = judged.after;
  if (is_refused) {
    judged.end = ChangeEnd::refused;
    if (after != before) judged.fault = "a refused change has changed something";
    return judged;
  }
  // Not a step of its own, or one whose start did not fit into the memory of undo.
  if (after["revision"] != before["revision"].get<int>() + 1 || after["undo"] == 0) return judged;
  // Nothing is undone while time runs.
  if (!after["time"].is_null()) return judged;
  // One of undo and redo themselves, or of a gesture that goes on.
  if (after["undo"].get<int>() <= before["undo"].get<int>()) return judged;
  judged.end = ChangeEnd::one_step;
  // Time that was stopped does not run again; it had changed nothing of the state.
  before["time"] = nullptr;
  const std::string scene_after = scene_text(ask);
  other({{"command", "undo"}});
  if (without_history(state_of(other)) != without_history(before) || scene_text(ask) != scene) {
    judged.fault = "undo leads elsewhere";
  }
  other({{"command", "redo"}});
  if (without_history(state_of(ask)) != without_history(after) || scene_text(ask) != scene_after) {
    judged.fault = "redo leads elsewhere";
  }
  return judged;
}

JudgedGrasp judge_grasp(const Ask& ask) {
  const Json state = state_of(ask);
  if (!is_ready(state)) return {};
  const std::string text = scene_text(ask);
  const Json grasp = result_of(ask, {{"command", "hand.auto_grasp"}});
  if (grasp.empty()) return {};
  JudgedGrasp judged{.is_evaluated = true};
  Trial trial;
  try {
    trial = evaluated(state, text);
  } catch (const InputError& error) {
    judged.fault = std::string("evaluate refuses: ") + error.what();
    judged.detail = text;
    return judged;
  }
  judged.is_stable = trial.outcome == Outcome::stable;
  if (is_same(grasp, trial)) return judged;
  judged.is_at_an_edge = is_same_nearby(grasp, state, text);
  if (judged.is_at_an_edge) return judged;
  judged.fault = "evaluate differs: " + grasp["outcome"].get<std::string>() + " " +
                 std::string(name_of(trial.outcome));
  judged.detail = grasp["epsilon"]["lower"].dump() + " " + std::to_string(trial.epsilon.lower) +
                  " " + state["hand"].dump() + " " + text;
  return judged;
}

bool promises_no_overlap(const Json& state) {
  return is_ready(state) && state["switches"]["stop_at_contact"] == true;
}

std::string overlap_of(const Ask& ask) {
  const Json overlaps =
      result_of(ask, {{"command", "collisions"}}).value("collisions", Json::array());
  return overlaps.empty() ? "" : overlaps[0].dump();
}

}  // namespace prehend::live_soak
