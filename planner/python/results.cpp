#include "planner/python/results.h"

#include <limits>
#include <pybind11/stl.h>

#include "planner/plan/grasp_text.h"
#include "planner/plan/plan.h"
#include "planner/python/arrays.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/trial/success.h"

namespace prehend::python {
namespace {

std::string text(std::string_view view) { return std::string(view); }

py::object name_or_none(const std::string& name) {
  return name.empty() ? py::none() : py::object(py::str(name));
}

// Arrays by field instead of objects by contact: NumPy users work on all contacts at once.
py::dict contacts_dict(const CompiledScene& scene, const std::vector<GraspContact>& contacts) {
  std::vector<Vector3> positions;
  std::vector<Vector3> normals;
  std::vector<double> friction;
  std::vector<double> torsion;
  std::vector<double> gap;
  std::vector<std::string> models;
  std::vector<std::string> links;
  for (const GraspContact& contact : contacts) {
    positions.emplace_back(contact.point.position);
    normals.emplace_back(contact.point.normal);
    friction.push_back(contact.point.friction);
    torsion.push_back(contact.point.torsion);
    gap.push_back(contact.gap);
    models.push_back(text(contact_model_name(contact.point.model)));
    links.push_back(scene.links[index(contact.link)].name);
  }
  py::dict fields;
  fields["positions"] = to_array(positions);
  fields["normals"] = to_array(normals);
  fields["friction"] = to_array(friction);
  fields["torsion"] = to_array(torsion);
  fields["gap"] = to_array(gap);
  fields["models"] = models;
  fields["links"] = links;
  return fields;
}

py::list named_counts(const PlanResult& result) {
  py::list stages;
  for (const auto& stage : result.stages)
    stages.append(py::make_tuple(text(plan_count_name(stage.what)), stage.count));
  return stages;
}

py::list blockers(const PlanResult& result) {
  py::list list;
  for (const CollisionCount& blocker : result.blockers) {
    list.append(py::make_tuple(text(outcome_name(blocker.outcome)), blocker.link, blocker.by,
                               blocker.count));
  }
  return list;
}

py::dict tried_dict(const std::vector<Tried>& tried) {
  std::vector<Pose> poses;
  std::vector<Vector3> approaches;
  std::vector<std::string> outcomes;
  std::vector<int> candidates;
  for (const Tried& one : tried) {
    candidates.push_back(one.candidate);
    poses.push_back(one.X_OH);
    approaches.push_back(one.approach_O);
    outcomes.push_back(text(outcome_name(one.outcome)));
  }
  py::dict fields;
  fields["candidates"] = to_array(candidates);
  fields["poses"] = to_array(poses);
  fields["approach"] = to_array(approaches);
  fields["outcomes"] = outcomes;
  return fields;
}

}  // namespace

py::dict trial_dict(const TrialHandle& handle) {
  const CompiledScene& scene = *handle.scene;
  const Trial& trial = handle.grasp->trial;
  const Candidate& candidate = handle.grasp->candidate;
  const CollisionNames why = collision_of(scene, trial);
  py::dict fields;
  fields["outcome"] = text(outcome_name(trial.outcome));
  fields["epsilon"] = trial.epsilon.lower;
  fields["epsilon_upper"] = trial.epsilon.upper;
  fields["epsilon_status"] = text(epsilon_status_name(trial.epsilon.status));
  fields["weakest_wrench"] =
      to_array(std::vector<double>(trial.epsilon.weakest.begin(), trial.epsilon.weakest.end()));
  fields["X_OH"] = to_array(trial.X_OH);
  fields["X_WH"] = to_array(Pose(scene.scene.object.X_WO * hand_in_scene(trial)));
  fields["approach"] = to_array(candidate.approach_O);
  fields["travel"] = trial.travel;
  fields["gave_way"] = to_array(trial.overlap_shift);
  fields["back_offs"] = trial.back_offs;
  fields["pushed"] = to_array(trial.pushed);
  fields["turned"] = trial.turned;
  fields["slid"] = trial.slid;
  fields["preshape"] = name_or_none(preshape_name(scene, candidate));
  fields["dofs"] = to_array(trial.dofs);
  fields["joints"] = to_array(trial.joints);
  fields["arm_dofs"] = trial.arm_dofs.empty() ? py::none() : py::object(to_array(trial.arm_dofs));
  fields["contacts"] = contacts_dict(scene, trial.contacts);
  fields["blocked_link"] = name_or_none(why.link);
  fields["blocked_by"] = name_or_none(why.by);
  fields["overlap"] = trial.overlap ? py::object(py::float_(*trial.overlap)) : py::none();
  return fields;
}

py::dict burden_dict(const LoadCase& load_case) {
  py::dict fields;
  fields["down"] = to_array(load_case.down_O);
  fields["sum_of_normals"] = load_case.sum_of_normals;
  fields["largest_normal"] = load_case.largest_normal;
  fields["strength"] = load_case.strength;
  return fields;
}

py::dict holding_dict(const PayloadMargin& holding) {
  py::dict fields;
  fields["given"] = burden_dict(holding.given);
  fields["worst"] = burden_dict(holding.worst);
  return fields;
}

py::dict robustness_dict(const Robustness& robustness) {
  const Interval interval = held_interval(robustness.held, robustness.samples);
  py::dict outcomes;
  for (const Outcome outcome : kOutcomes) {
    const int count = robustness.outcomes[static_cast<std::size_t>(outcome)];
    if (count > 0) outcomes[py::str(text(outcome_name(outcome)))] = count;
  }
  py::dict fields;
  fields["samples"] = robustness.samples;
  fields["held"] = robustness.held;
  fields["interval"] = py::make_tuple(interval.lower, interval.upper);
  fields["epsilon_mean"] = robustness.epsilon_mean;
  fields["epsilon_low"] = robustness.epsilon_low;
  fields["outcomes"] = outcomes;
  fields["spare"] = robustness.position_margin;
  fields["weakest"] = to_array(robustness.weakest_O);
  fields["weakest_outcome"] = text(outcome_name(robustness.weakest_end));
  fields["strength"] = robustness.strength;
  fields["success"] = success_probability(robustness);
  return fields;
}

py::dict grasp_dict(const PlanHandle& plan, std::size_t grasp) {
  const ScoredGrasp& scored = plan.result->grasps.at(grasp);
  // Refers to the grasp inside the result and keeps the whole result alive, without copying the
  // grasp.
  const std::shared_ptr<const ScoredGrasp> shared(plan.result, &scored);
  const TrialHandle handle{plan.scene, shared};
  py::dict fields = trial_dict(handle);
  // Not computed: the run was cancelled before.
  fields["volume"] = scored.volume.value_or(std::numeric_limits<double>::quiet_NaN());
  fields["epsilon_nearby"] =
      scored.epsilon_nearby
          ? py::object(py::make_tuple(scored.epsilon_nearby->lower, scored.epsilon_nearby->upper))
          : py::none();
  fields["holding"] = scored.holding ? py::object(holding_dict(*scored.holding)) : py::none();
  fields["robustness"] =
      scored.robustness ? py::object(robustness_dict(*scored.robustness)) : py::none();
  fields["primitive"] = scored.primitive;
  fields["rule"] = scored.rule;
  fields["refinement"] =
      scored.refinement
          ? py::object(py::make_tuple(scored.refinement->gain, scored.refinement->trials))
          : py::none();
  fields["path"] = scored.path ? py::object(path_dict(*scored.path, scored.lift)) : py::none();
  fields["candidate"] = candidate_dict(*plan.scene, scored.candidate);
  fields["_trial"] = handle;
  return fields;
}

py::list advice(const PlanResult& result) {
  py::list list;
  for (const Advice& one : result.advice) {
    list.append(py::make_tuple(text(hint_name(one.hint)), text(one.words)));
  }
  return list;
}

// Rule and outcomes, those with at least one candidate.
py::list rules(const PlanResult& result) {
  py::list list;
  for (const RuleCount& rule : result.rules) {
    py::dict counts;
    for (const Outcome outcome : kOutcomes) {
      const int count = rule.outcomes[static_cast<std::size_t>(outcome)];
      if (count > 0) counts[py::str(text(outcome_name(outcome)))] = count;
    }
    list.append(py::make_tuple(rule.rule, counts));
  }
  return list;
}

py::dict result_dict(const PlanHandle& plan) {
  const PlanResult& result = *plan.result;
  py::dict outcomes;
  for (const Outcome outcome : kOutcomes) {
    outcomes[py::str(text(outcome_name(outcome)))] =
        result.outcomes[static_cast<std::size_t>(outcome)];
  }
  py::list primitives;
  for (const Primitive& primitive : result.primitives) primitives.append(primitive_dict(primitive));
  py::dict times;
  for (const StageTime& time : result.times)
    times[py::str(text(stage_name(time.stage)))] = time.seconds;
  py::dict fields;
  fields["status"] = text(plan_status_name(result.status));
  fields["untested"] = result.untested;
  fields["ways"] = result.families;
  fields["ways_untested"] = result.families_untested;
  fields["smallest_width"] = result.smallest_width;
  fields["largest_opening"] = result.largest_opening;
  fields["words"] =
      result.status == PlanStatus::object_too_large || result.status == PlanStatus::no_candidates
          ? no_candidates_text(*plan.scene, result)
          : "";
  fields["advice"] = advice(result);
  fields["rules"] = rules(result);
  fields["outcomes"] = outcomes;
  fields["blockers"] = blockers(result);
  fields["stages"] = named_counts(result);
  fields["seconds"] = times;
  fields["primitives"] = primitives;
  fields["tried"] = tried_dict(result.tried);
  fields["count"] = result.grasps.size();
  return fields;
}

py::dict path_dict(const Trajectory& path, LiftEnd lift) {
  py::list segments;
  for (const TrajectorySegment& segment : path.segments) {
    segments.append(py::make_tuple(segment.name, segment.first, segment.last));
  }
  py::dict fields;
  fields["joints"] = path.joints;
  fields["times"] = to_array(path.times);
  fields["positions"] = to_array(path.positions, path.joints.size());
  fields["velocities"] = to_array(path.velocities, path.joints.size());
  fields["segments"] = segments;
  fields["lift"] = text(lift_end_name(lift));
  return fields;
}

py::dict candidate_dict(const CompiledScene& scene, const Candidate& candidate) {
  py::dict fields;
  fields["X_OH"] = to_array(candidate.X_OH);
  fields["approach"] = to_array(candidate.approach_O);
  fields["approach_distance"] = candidate.approach_distance;
  fields["preshape"] = name_or_none(preshape_name(scene, candidate));
  fields["dofs"] = !candidate.preshape ? py::object(to_array(candidate.dofs)) : py::none();
  fields["joints"] = !candidate.preshape && !candidate.joints.empty()
                         ? py::object(to_array(candidate.joints))
                         : py::none();
  return fields;
}

Candidate candidate_from(const py::dict& fields) {
  Candidate candidate;
  candidate.X_OH = pose_of(fields["X_OH"].cast<Doubles>());
  candidate.approach_O = vector_of(fields["approach"].cast<Doubles>());
  candidate.approach_distance = fields["approach_distance"].cast<double>();
  candidate.preshape = fields["preshape"].cast<std::optional<int>>();
  candidate.dofs = numbers_of(fields["dofs"].cast<Doubles>());
  candidate.joints = numbers_of(fields["joints"].cast<Doubles>());
  return candidate;
}

py::dict primitive_dict(const Primitive& primitive) {
  py::dict fields;
  fields["shape"] = text(shape_name(primitive.shape));
  fields["X_OP"] = to_array(primitive.X_OP);
  if (const auto* box = std::get_if<Box>(&primitive.shape)) fields["size"] = to_array(box->size);
  if (const auto* sphere = std::get_if<Sphere>(&primitive.shape)) fields["radius"] = sphere->radius;
  if (const auto* cylinder = std::get_if<Cylinder>(&primitive.shape)) {
    fields["radius"] = cylinder->radius;
    fields["height"] = cylinder->height;
  }
  if (const auto* cone = std::get_if<Cone>(&primitive.shape)) {
    fields["radius_low"] = cone->radius_low;
    fields["radius_high"] = cone->radius_high;
    fields["height"] = cone->height;
  }
  if (const auto* rim = std::get_if<Rim>(&primitive.shape)) {
    std::vector<Vector3> into;
    std::vector<Vector3> across;
    for (const RimPoint& at : rim->points) {
      into.push_back(at.into);
      across.push_back(at.across);
    }
    fields["points"] = to_array(points_of(*rim));
    fields["into"] = to_array(into);
    fields["across"] = to_array(across);
    fields["width"] = rim->width;
    fields["depth"] = rim->depth;
    fields["closed"] = rim->closed;
  }
  if (const auto* bar = std::get_if<Bar>(&primitive.shape)) {
    fields["points"] = to_array(bar->points);
    fields["width"] = bar->width;
    fields["closed"] = bar->closed;
  }
  return fields;
}

Primitive primitive_from(const py::dict& fields) {
  const auto shape = fields["shape"].cast<std::string>();
  const Pose X_OP = pose_of(fields["X_OP"].cast<Doubles>());
  if (shape == "box") return {Box{vector_of(fields["size"].cast<Doubles>())}, X_OP};
  if (shape == "sphere") return {Sphere{fields["radius"].cast<double>()}, X_OP};
  if (shape == "cylinder") {
    return {Cylinder{fields["radius"].cast<double>(), fields["height"].cast<double>()}, X_OP};
  }
  if (shape == "cone") {
    return {Cone{fields["radius_low"].cast<double>(), fields["radius_high"].cast<double>(),
                 fields["height"].cast<double>()},
            X_OP};
  }
  if (shape == "rim") {
    const std::vector<Vector3> points = vectors_of(fields["points"].cast<Doubles>());
    const std::vector<Vector3> into = vectors_of(fields["into"].cast<Doubles>());
    const std::vector<Vector3> across = vectors_of(fields["across"].cast<Doubles>());
    Rim rim{{},
            fields["width"].cast<double>(),
            fields["depth"].cast<double>(),
            fields["closed"].cast<bool>()};
    for (std::size_t i = 0; i < points.size(); ++i) {
      rim.points.push_back({points[i], into[i], across[i]});
    }
    return {rim, X_OP};
  }
  if (shape == "bar") {
    return {Bar{vectors_of(fields["points"].cast<Doubles>()), fields["width"].cast<double>(),
                fields["closed"].cast<bool>()},
            X_OP};
  }
  throw InputError({.field = "shape",
                    .problem = "not one of box, sphere, cylinder, cone, rim, bar",
                    .value = shape});
}

}  // namespace prehend::python
