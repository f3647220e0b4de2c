// What a plan found as dictionaries of NumPy arrays, one key for each field of the classes in
// prehend/results.py.
#pragma once

#include <memory>
#include <pybind11/pybind11.h>

#include "planner/python/scene_handle.h"
#include "planner/results/grasps_file.h"

namespace prehend::python {

// A trial with what it is a trial of: all that a path or a picture needs later.
struct TrialHandle {
  std::shared_ptr<const CompiledScene> scene;
  std::shared_ptr<const ScoredGrasp> grasp;
};

// A plan with its scene and what it was asked: all that its files say.
struct PlanHandle {
  std::shared_ptr<const CompiledScene> scene;
  std::shared_ptr<const PlanResult> result;
  RunRecord record;
};

// `primitives`: which the grasp may refer to.
pybind11::dict trial_dict(const TrialHandle& handle, const std::vector<Primitive>& primitives);
pybind11::dict grasp_dict(const PlanHandle& plan, std::size_t grasp);
pybind11::dict result_dict(const PlanHandle& plan);  // all but the grasps
pybind11::dict primitive_dict(const Primitive& primitive);
pybind11::dict decomposition_dict(const Decomposition& found);
pybind11::dict path_dict(const Trajectory& path, LiftEnd lift);
pybind11::dict candidate_dict(const CompiledScene& scene, const Candidate& candidate);

// The inverse of primitive_dict. Throws InputError for an unknown shape.
Primitive primitive_from(const pybind11::dict& fields);
// The inverse of candidate_dict, but for preshape and strategy: their numbers, or None.
Candidate candidate_from(const pybind11::dict& fields);

}  // namespace prehend::python
