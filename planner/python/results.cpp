#include "planner/python/results.h"

#include <limits>
#include <pybind11/stl.h>

#include "planner/plan/grasp_text.h"
#include "planner/plan/plan.h"
#include "planner/python/arrays.h"
#include "planner/python/dictionary_writer.h"
#include "planner/results/grasp_fields.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/scene/seen_surface.h"
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
  std::vector<double> moment;
  std::vector<double> vacuum;
  std::vector<double> gap;
  std::vector<std::string> models;
  std::vector<std::string> links;
  std::vector<std::optional<bool>> seen;
  for (const GraspContact& contact : contacts) {
    positions.emplace_back(contact.point.position);
    normals.emplace_back(contact.point.normal);
    friction.push_back(contact.point.friction);
    torsion.push_back(contact.point.torsion);
    moment.push_back(contact.point.moment);
    vacuum.push_back(contact.point.vacuum);
    gap.push_back(contact.gap);
    models.push_back(text(name_of(contact.point.model)));
    links.push_back(scene.links[index(contact.link)].name);
    seen.push_back(is_seen_at(scene, contact.point.position));
  }
  py::dict fields;
  fields["positions"] = to_array(positions);
  fields["normals"] = to_array(normals);
  fields["friction"] = to_array(friction);
  fields["torsion"] = to_array(torsion);
  fields["moment"] = to_array(moment);
  fields["vacuum"] = to_array(vacuum);
  fields["gap"] = to_array(gap);
  fields["models"] = models;
  fields["links"] = links;
  fields["seen"] = py::cast(seen);
  return fields;
}

py::list named_counts(const PlanResult& result) {
  py::list stages;
  for (const auto& stage : result.stages)
    stages.append(py::make_tuple(text(name_of(stage.what)), stage.count));
  return stages;
}

py::list blockers(const PlanResult& result) {
  py::list list;
  for (const CollisionCount& blocker : result.blockers) {
    list.append(
        py::make_tuple(text(name_of(blocker.outcome)), blocker.link, blocker.by, blocker.count));
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
    outcomes.push_back(text(name_of(one.outcome)));
  }
  py::dict fields;
  fields["candidates"] = to_array(candidates);
  fields["poses"] = to_array(poses);
  fields["approach"] = to_array(approaches);
  fields["outcomes"] = outcomes;
  return fields;
}

// What prehend/results.py has in other shapes than files: an object there is a tuple, or its
// fields stand among those of the grasp.
void reshape(py::dict& fields) {
  const auto taken = [&](const char* name) {
    return py::reinterpret_borrow<py::object>(fields.attr("pop")(name));
  };
  const auto values = [](const py::object& object) {
    return object.is_none() ? object : py::tuple(object.attr("values")());
  };
  for (const char* name : {"epsilon_nearby", "refinement"}) {
    fields[name] = values(fields[name]);
  }
  const py::object blocked = taken("blocked");
  for (const auto& [name, whole] :
       {std::pair{"link", "blocked_link"}, std::pair{"by", "blocked_by"},
        std::pair{"overlap", "overlap"}}) {
    fields[whole] = blocked.is_none() ? blocked : py::object(blocked[name]);
  }
  const py::object primitive = taken("primitive");
  fields["primitive"] = primitive.is_none() ? primitive : py::object(primitive["index"]);
  // The object "approach" has the direction under its own name.
  const py::object approach = taken("approach");
  fields.attr("update")(approach);
}

py::list shake_tests(const ShakeReport& report) {
  py::list tests;
  for (const ShakeTestReport& test : report.tests) {
    DictionaryWriter of_test;
    shake_test_fields(of_test, test);
    py::dict fields = std::move(of_test).fields();
    py::list phases;
    for (const PhaseReport& phase : test.phases) {
      DictionaryWriter of_phase;
      phase_fields(of_phase, phase);
      phases.append(std::move(of_phase).fields());
    }
    fields["phases"] = phases;
    tests.append(fields);
  }
  return tests;
}

}  // namespace

py::dict trial_dict(const TrialHandle& handle, const std::vector<Primitive>& primitives) {
  const CompiledScene& scene = *handle.scene;
  const ScoredGrasp& grasp = *handle.grasp;
  const Trial& trial = grasp.trial;
  DictionaryWriter writer;
  grasp_fields(writer, grasp, scene, primitives);
  py::dict fields = std::move(writer).fields();
  reshape(fields);
  if (grasp.pads) {
    py::list patches;
    for (const PadPatchReport& patch : grasp.pads->patches) {
      DictionaryWriter of_patch;
      pad_patch_fields(of_patch, patch, link_names(scene));
      patches.append(std::move(of_patch).fields());
    }
    fields["pads"]["patches"] = patches;
  }
  if (grasp.shake) fields["shake"]["tests"] = shake_tests(*grasp.shake);
  fields["epsilon"] = trial.epsilon.lower;
  fields["epsilon_upper"] = trial.epsilon.upper;
  fields["epsilon_status"] = in_python(trial.epsilon.status);
  fields["weakest_wrench"] =
      to_array(std::vector<double>(trial.epsilon.weakest.begin(), trial.epsilon.weakest.end()));
  fields["rule"] = grasp.rule;
  fields["preferred"] = trial.preferred;
  fields["contacts"] = contacts_dict(scene, trial.contacts);
  fields["candidate"] = candidate_dict(scene, grasp.candidate);
  fields["path"] = grasp.path ? py::object(path_dict(*grasp.path, grasp.lift)) : py::none();
  fields["_trial"] = handle;
  return fields;
}

py::dict grasp_dict(const PlanHandle& plan, std::size_t grasp) {
  const ScoredGrasp& scored = plan.result->grasps.at(grasp);
  // Refers to the grasp inside the result and keeps the whole result alive, without copying the
  // grasp.
  const std::shared_ptr<const ScoredGrasp> shared(plan.result, &scored);
  py::dict fields = trial_dict({plan.scene, shared}, plan.result->primitives);
  // Not computed: the run was cancelled before.
  fields["volume"] = scored.volume.value_or(std::numeric_limits<double>::quiet_NaN());
  return fields;
}

py::list advice(const PlanResult& result) {
  py::list list;
  for (const Advice& one : result.advice) {
    list.append(py::make_tuple(text(name_of(one.hint)), text(one.words)));
  }
  return list;
}

// Rule and outcomes, those with at least one candidate.
py::list rules(const PlanResult& result) {
  py::list list;
  for (const RuleCount& rule : result.rules) {
    py::dict counts;
    for (const Outcome outcome : kAll<Outcome>) {
      const int count = rule.outcomes[outcome];
      if (count > 0) counts[py::str(text(name_of(outcome)))] = count;
    }
    list.append(py::make_tuple(rule.rule, counts));
  }
  return list;
}

py::tuple distances_tuple(const SurfaceDistances& distances) {
  return py::make_tuple(distances.median, distances.percentile_95, distances.largest);
}

py::dict decomposition_dict(const Decomposition& found) {
  py::list primitives;
  for (const Primitive& primitive : found.primitives) primitives.append(primitive_dict(primitive));
  py::dict fields;
  fields["primitives"] = primitives;
  fields["share"] = to_array(found.share);
  fields["explained"] = found.explained;
  fields["tolerance"] = found.tolerance;
  fields["distances"] = distances_tuple(found.distances);
  py::list distances_of;
  for (const SurfaceDistances& distances : found.distances_of) {
    distances_of.append(distances_tuple(distances));
  }
  fields["distances_of"] = distances_of;
  return fields;
}

py::dict result_dict(const PlanHandle& plan) {
  const PlanResult& result = *plan.result;
  py::dict outcomes;
  for (const Outcome outcome : kAll<Outcome>) {
    outcomes[py::str(text(name_of(outcome)))] = result.outcomes[outcome];
  }
  py::list primitives;
  for (const Primitive& primitive : result.primitives) primitives.append(primitive_dict(primitive));
  py::dict times;
  for (const StageTime& time : result.times)
    times[py::str(text(name_of(time.stage)))] = time.seconds;
  py::dict fields;
  fields["status"] = text(name_of(result.status));
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
  fields["solids"] = py::none();
  if (result.solids) fields["solids"] = decomposition_dict(*result.solids);
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
  fields["lift"] = text(name_of(lift));
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
  fields["strategy"] = name_or_none(strategy_of(scene.scene.hand, candidate).name);
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
  candidate.strategy = fields["strategy"].cast<std::optional<int>>();
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
