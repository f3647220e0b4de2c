#include <optional>
#include <pybind11/stl.h>
#include <utility>

#include "planner/plan/path/arm_path.h"
#include "planner/plan/plan_any.h"
#include "planner/plan/shake_grasps.h"
#include "planner/python/arrays.h"
#include "planner/python/background.h"
#include "planner/python/results.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"
#include "sim/manipulation/test_procedure_file.h"
#include "sim/scene/compiled_scene.h"
#include "sim/scene/reach/reach.h"
#include "sim/trial/run_trial.h"

namespace prehend::python {
namespace {

// What every long call takes from Python besides its own arguments.
CallOptions call_options(int threads, py::object progress, const Cancellation& cancellation,
                         double seconds) {
  return {threads, std::move(progress), cancellation, Deadline::in(seconds)};
}

RunRecord record_of(const SceneOrigin& origin, const PlanOptions& options) {
  return {origin.file, origin.unit, origin.hand, options, origin.repair, origin.choice};
}

void require_model(const PlanOptions& options) {
  require(!options.search.learned || options.search.learned->model,
          {.field = "options.search.learned", .problem = "has no model"});
}

PlanHandle plan_in_python(const CompiledHandle& scene, const PlanOptions& asked,
                          const CallOptions& call) {
  const PlanOptions options = asked;  // as they are now: Python may change them meanwhile
  require_model(options);
  PlanResult result;
  run_in_background(
      call, [&](const RunContext& context) { result = plan(*scene.scene, options, context); });
  return {scene.scene, std::make_shared<const PlanResult>(std::move(result)),
          record_of(scene.origin, options)};
}

// The plans, the grasps of all in their order, and what must go first.
py::tuple plan_any_in_python(const std::vector<CompiledHandle>& scenes, const PlanOptions& asked,
                             const CallOptions& call) {
  const PlanOptions options = asked;
  require_model(options);
  std::vector<CompiledScene> compiled;
  for (const CompiledHandle& scene : scenes) compiled.push_back(*scene.scene);
  AnyPlan any;
  run_in_background(call,
                    [&](const RunContext& context) { any = plan_any(compiled, options, context); });
  py::list plans;
  for (std::size_t s = 0; s < scenes.size(); ++s) {
    plans.append(PlanHandle{scenes[s].scene,
                            std::make_shared<const PlanResult>(std::move(any.results[s])),
                            record_of(scenes[s].origin, options)});
  }
  py::list ranked;
  for (const AnyGrasp& one : any.ranked) ranked.append(py::make_tuple(one.scene, one.grasp));
  return py::make_tuple(plans, ranked, any.first);
}

std::vector<Candidate> candidates_from(const CompiledScene& scene, const py::list& list) {
  std::vector<Candidate> candidates;
  for (const py::handle& fields : list) {
    candidates.push_back(candidate_from(fields.cast<py::dict>()));
    const Candidate& candidate = candidates.back();
    const Robot& hand = scene.scene.hand;
    // prehend/_candidates.py has refused these cases with the name of the argument. They are tested
    // again, because run_trial requires them and looks no further.
    const bool sound =
        candidate.preshape.has_value()
            ? index(*candidate.preshape) < hand.hand->preshapes.size()
            : candidate.dofs.size() == hand.dofs.size() &&
                  (candidate.joints.empty() || candidate.joints.size() == hand.joints.size());
    const bool closes =
        !candidate.strategy || index(*candidate.strategy) < hand.hand->strategies.size();
    if (!sound || !closes) throw std::invalid_argument("candidate: not of this hand");
  }
  return candidates;
}

PlanHandle evaluate_in_python(const CompiledHandle& scene, const py::list& list,
                              const EvaluateOptions& asked, const CallOptions& call) {
  const EvaluateOptions options = asked;
  const std::vector<Candidate> candidates = candidates_from(*scene.scene, list);
  PlanResult result;
  run_in_background(call, [&](const RunContext& context) {
    result = evaluate(*scene.scene, candidates, options, context);
  });
  // Files state settings as PlanOptions. An evaluation has only these of them; the others keep
  // their defaults.
  PlanOptions recorded;
  recorded.seed = options.seed;
  recorded.trial = options.trial;
  recorded.sections = options.sections;
  return {scene.scene, std::make_shared<const PlanResult>(std::move(result)),
          record_of(scene.origin, recorded)};
}

// Of these grasps of a plan.
PlanHandle with_grasps(const PlanHandle& plan, const std::vector<std::size_t>& kept) {
  PlanResult result = *plan.result;
  result.grasps.clear();
  for (const std::size_t i : kept) result.grasps.push_back(plan.result->grasps.at(i));
  return {plan.scene, std::make_shared<const PlanResult>(std::move(result)), plan.record};
}

PlanHandle shake_in_python(const PlanHandle& plan, const std::string& procedure, bool rank,
                           const CallOptions& call) {
  const TestProcedure tests = read_test_procedure(find_test_procedure(procedure));
  PlanResult result = *plan.result;
  run_in_background(call, [&](const RunContext& context) {
    shake_grasps(*plan.scene, tests, context, result);
    if (rank) rank_by_shake(result);
  });
  return {plan.scene, std::make_shared<const PlanResult>(std::move(result)), plan.record};
}

// What a file says of its scene, for load_scene.
py::dict scene_of_grasps(const std::string& file) {
  const SceneReference asked = read_scene_reference(JsonFile(file));
  py::dict fields;
  fields["scene"] = asked.scene;
  fields["hand"] = asked.hand;
  fields["unit"] = asked.unit;
  fields["repair"] = asked.repair;
  fields["object"] = asked.choice.object;
  return fields;
}

PlanHandle load_grasps_in_python(const CompiledHandle& scene, const std::string& file) {
  GraspFile read = read_grasps(JsonFile(file), *scene.scene);
  return {scene.scene, std::make_shared<const PlanResult>(std::move(read.result)),
          std::move(read.record)};
}

py::dict run_trial_in_python(const CompiledHandle& scene, const py::dict& fields,
                             const TrialOptions& asked, const CallOptions& call) {
  const TrialOptions options = asked;
  // Through the checks that a list of candidates goes through.
  py::list list;
  list.append(fields);
  auto grasp = std::make_shared<ScoredGrasp>();
  grasp->candidate = candidates_from(*scene.scene, list).front();
  run_in_background(call, [&](const RunContext& context) {
    grasp->trial = run_trial(*scene.scene, grasp->candidate, options, context);
  });
  return trial_dict({scene.scene, grasp}, {});
}

py::dict decompose_in_python(const Doubles& vertices, const Integers& faces,
                             const DecomposeOptions& asked, const CallOptions& call) {
  const DecomposeOptions options = asked;
  const TriangleMesh mesh = mesh_of(vertices, faces);
  Decomposition found;
  run_in_background(call,
                    [&](const RunContext& context) { found = decompose(mesh, options, context); });
  return decomposition_dict(found);
}

py::dict propose_in_python(const CompiledHandle& scene, const py::list& list, std::size_t count,
                           const CandidateOptions& asked, const CallOptions& call) {
  const CandidateOptions options = asked;
  std::vector<Primitive> primitives;
  for (const py::handle& fields : list) {
    primitives.push_back(primitive_from(fields.cast<py::dict>()));
  }
  Proposals proposals;
  run_in_background(call, [&](const RunContext& context) {
    proposals = propose_grasps(*scene.scene, primitives, count, options, context);
  });
  py::list grasps;
  for (const ProposedGrasp& proposed : proposals.grasps) {
    grasps.append(py::make_tuple(candidate_dict(*scene.scene, proposed.candidate),
                                 proposed.primitive, proposed.rule));
  }
  py::dict fields;
  fields["grasps"] = grasps;
  fields["smallest_width"] = proposals.smallest_width;
  fields["largest_opening"] = proposals.largest_opening;
  return fields;
}

py::object plan_path_in_python(const TrialHandle& trial, const GraspPathOptions& asked,
                               const CallOptions& call) {
  const GraspPathOptions options = asked;
  const ScoredGrasp& grasp = *trial.grasp;
  // plan_grasp_path requires both. prehend/planning.py refuses them before, with a message in
  // words.
  if (!trial.scene->arm || grasp.trial.outcome != Outcome::stable) {
    throw std::invalid_argument("no stable grasp of an arm");
  }
  std::optional<GraspPath> path;
  run_in_background(call, [&](const RunContext& context) {
    path = plan_grasp_path(*trial.scene, grasp.candidate, grasp.trial, options, context);
  });
  return path ? py::object(path_dict(path->motion, path->lift)) : py::none();
}

// To the postures, or to those that have the hand's base at the pose.
py::dict plan_arm_path_in_python(const CompiledHandle& scene,
                                 const std::vector<std::vector<double>>& postures,
                                 const std::optional<Doubles>& X_WH, bool straight,
                                 const GraspPathOptions& asked, const CallOptions& call) {
  const GraspPathOptions options = asked;
  const CompiledScene& compiled = *scene.scene;
  // prehend/planning.py refuses others before, with a message in words.
  if (!compiled.arm) throw std::invalid_argument("no arm");
  std::vector<DofValues> goals(postures.begin(), postures.end());
  std::optional<Pose> pose;
  if (X_WH) pose = pose_of(*X_WH);
  ArmPath path;
  run_in_background(call, [&](const RunContext& context) {
    if (pose && straight) {
      path = plan_arm_line(compiled, *pose, options, context);
      return;
    }
    if (pose) {
      const Pose X_OH = compiled.scene.object.X_WO.inverse() * *pose;
      goals = postures_at(*compiled.arm, X_OH, options.reach, context);
    }
    path = plan_arm_path(compiled, goals, options, context);
  });
  py::dict fields;
  fields["end"] = std::string(name_of(path.end));
  fields["why"] = path.why;
  const bool is_found = path.end == ArmPathEnd::found;
  fields["path"] = is_found ? py::object(path_dict(path.motion, LiftEnd::not_asked)) : py::none();
  fields["relative_length"] = is_found ? relative_length(path.waypoints) : 0.0;
  return fields;
}

}  // namespace

void bind_plan(py::module_& core) {
  py::class_<CallOptions>(core, "_CallOptions").def(py::init(&call_options));
  const py::class_<TrialHandle> trial(core, "_Trial");
  py::class_<PlanHandle>(core, "_PlanResult").def("fields", &result_dict).def("grasp", &grasp_dict);
  core.def("plan", &plan_in_python);
  core.def("plan_any", &plan_any_in_python);
  core.def("evaluate", &evaluate_in_python);
  core.def("with_grasps", &with_grasps);
  core.def("shake_grasps", &shake_in_python);
  core.def("scene_of_grasps", &scene_of_grasps);
  core.def("load_grasps", &load_grasps_in_python);
  core.def("library_test_procedures", &library_test_procedure_names);
  core.def("run_trial", &run_trial_in_python);
  core.def("decompose", &decompose_in_python);
  core.def("propose_grasps", &propose_in_python);
  core.def("given_primitives", [](const CompiledHandle& scene) {
    py::list list;
    for (const Primitive& primitive : scene.scene->scene.primitives) {
      list.append(primitive_dict(primitive));
    }
    return list;
  });
  core.def("plan_grasp_path", &plan_path_in_python);
  core.def("plan_arm_path", &plan_arm_path_in_python);
}

}  // namespace prehend::python
