#include <pybind11/pybind11.h>
#include <sstream>
#include <string>

#include "planner/plan/plan_result.h"
#include "planner/plan/propose/candidates.h"
#include "primitives/decompose.h"
#include "sim/motion/control/run_controlled.h"
#include "sim/motion/step_world.h"
#include "sim/quality/forces.h"
#include "sim/trial/candidate.h"
#include "sim/trial/perturbed_trials.h"
#include "sim/trial/trial.h"

namespace prehend::python {
namespace {

namespace py = pybind11;

// "a, b" as ("a", "b").
py::tuple split(const std::string& names) {
  py::list list;
  std::istringstream stream(names);
  for (std::string name; std::getline(stream, name, ',');) {
    list.append(name.substr(name.find_first_not_of(' ')));
  }
  return py::tuple(list);
}

}  // namespace

// All members of a struct. A structured binding does not compile while one is missing.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): names of members are no values
#define PREHEND_FIELDS(Struct, ...)                          \
  fields[#Struct] = split(#__VA_ARGS__);                     \
  static_assert([] {                                         \
    [[maybe_unused]] const auto look = [](const Struct& s) { \
      [[maybe_unused]] const auto& [__VA_ARGS__] = s;        \
    };                                                       \
    return true;                                             \
  }())

// The fields that the results of the library have, by struct: tests compare them with those of the
// Python classes.
void bind_fields(py::module_& core) {
  py::dict fields;
  PREHEND_FIELDS(SurfaceDistances, median, percentile_95, largest);
  PREHEND_FIELDS(Decomposition, primitives, share, explained, tolerance, distances, distances_of);
  PREHEND_FIELDS(Candidate, X_OH, approach_O, approach_distance, preshape, dofs, joints, strategy);
  PREHEND_FIELDS(ProposedGrasp, candidate, primitive, rule, width, stand_off, way, choices, level,
                 preferred);
  PREHEND_FIELDS(Proposals, grasps, smallest_width, largest_opening);
  PREHEND_FIELDS(GraspContact, link, point, gap);
  PREHEND_FIELDS(Trial, outcome, blocked, overlap, arm_pair, X_OH, travel, overlap_shift, back_offs,
                 pushed, turned, slid, X_OC, dofs, joints, arm_line, arm_dofs, contacts, epsilon,
                 preferred, seconds);
  PREHEND_FIELDS(LoadCase, down_O, sum_of_normals, largest_normal, strength);
  PREHEND_FIELDS(PayloadMargin, given, worst);
  PREHEND_FIELDS(HeldByPads, patches, stiffness, softest);
  PREHEND_FIELDS(FreeEnd, kept, epsilon, strength, moved);
  PREHEND_FIELDS(Robustness, samples, held, epsilon_mean, epsilon_low, epsilons, outcomes, strength,
                 free, position_margin, weakest_O, weakest_end);
  PREHEND_FIELDS(Refinement, parent, gain, trials);
  PREHEND_FIELDS(ScoredGrasp, trial, candidate, volume, primitive, rule, path, sections, tried,
                 epsilon_nearby, holding, pads, robustness, refinement, free, shake, shapes, lift);
  PREHEND_FIELDS(PhaseReport, kind, seconds, moved, turned, sank, rose, touching);
  PREHEND_FIELDS(FirstSlip, link, time);
  PREHEND_FIELDS(ShakeTestReport, name, outcome, failed_at, phases, first_slip, largest_pull);
  PREHEND_FIELDS(HeldShapes, likely, thin, thick, unseen, certainty);
  PREHEND_FIELDS(Tried, candidate, X_OH, approach_O, outcome, collision_of);
  PREHEND_FIELDS(CollisionCount, outcome, link, by, count);
  PREHEND_FIELDS(RuleCount, rule, outcomes);
  PREHEND_FIELDS(StageCount, what, count);
  PREHEND_FIELDS(Advice, hint, words);
  PREHEND_FIELDS(PlanResult, status, untested, families, families_untested, smallest_width,
                 largest_opening, primitives, solids, grasps, tried, outcomes, blockers, rules,
                 advice, stages, times, trial_seconds);
  PREHEND_FIELDS(TrajectorySegment, name, first, last);
  PREHEND_FIELDS(Trajectory, joints, times, positions, velocities, segments);
  PREHEND_FIELDS(ContactForces, outcome, components, forces, largest_normal, sum_of_normals,
                 residual, lowest, gap, separating, torque_multipliers);
  PREHEND_FIELDS(StepResult, outcome, time, newton_steps, shortened, crossings, violation);
  PREHEND_FIELDS(ControlledRun, outcome, time, steps, not_converged, why);
  core.attr("fields_of_results") = fields;
}

#undef PREHEND_FIELDS

}  // namespace prehend::python
