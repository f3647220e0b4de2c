#include <algorithm>
#include <array>
#include <string>

#include "planner/plan/accuracy.h"
#include "planner/plan/advice.h"
#include "planner/plan/path/lift_object.h"
#include "planner/plan/plan.h"
#include "planner/python/enum_names.h"
#include "planner/show/validation/bootstrap.h"
#include "planner/show/validation/open_hand.h"
#include "sim/base/material.h"
#include "sim/base/run_context.h"
#include "sim/motion/control/run_controlled.h"
#include "sim/motion/world.h"
#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/forces.h"
#include "sim/trial/outcome.h"

namespace prehend::python {
namespace {

namespace py = pybind11;

template <class Enum>
using TextOf = std::string_view (*)(Enum);

// A class of strings, one for each value; a space in a name is an underscore in its member. What a
// value means is the docstring of its member.
template <class Enum, std::size_t count>
void add_enum(py::module_& core, const char* name, const char* doc,
              const std::array<Enum, count>& values, TextOf<Enum> name_of,
              TextOf<Enum> meaning_of = nullptr) {
  py::list members;
  for (const Enum value : values) {
    const std::string text(name_of(value));
    std::string member = text;
    std::replace(member.begin(), member.end(), ' ', '_');
    members.append(py::make_tuple(member, text));
  }
  const py::object base = py::module_::import("prehend._names").attr("NamedEnum");
  const py::object made = base(name, members, py::arg("module") = "prehend._core");
  made.attr("__doc__") = doc;
  if (meaning_of != nullptr) {
    for (const Enum value : values) {
      made(std::string(name_of(value))).attr("__doc__") = std::string(meaning_of(value));
    }
  }
  core.attr(name) = made;
}

// The values of an enumeration from its first to `last`.
template <std::size_t count, class Enum>
std::array<Enum, count> all_up_to(Enum last) {
  std::array<Enum, count> values;
  for (std::size_t i = 0; i < count; ++i) values.at(i) = static_cast<Enum>(i);
  if (values.back() != last) throw std::logic_error("an enumeration has other values");
  return values;
}

void add_enums_of_quality(py::module_& core) {
  add_enum(core, "ContactModel", "What a contact can exert.", kContactModels, &contact_model_name);
  add_enum(core, "EpsilonStatus", "How the search for epsilon ended.",
           all_up_to<5>(EpsilonStatus::stalled), &epsilon_status_name);
  add_enum(core, "ForceOutcome", "What is known about balancing forces.",
           all_up_to<3>(ForceOutcome::limit), &force_outcome_name);
}

void add_enums_of_motion(py::module_& core) {
  add_enum(core, "StepOutcome", "How a step of a world ended.", kStepOutcomes, &step_outcome_name);
  add_enum(core, "ControlOutcome", "How a run with controllers ended.", kControlOutcomes,
           &control_outcome_name);
}

void add_enums_of_validation(py::module_& core) {
  add_enum(core, "ObjectPlace", "Where the object is in the open hand.", kObjectPlaces,
           &object_place_name);
  add_enum(core, "Grouping", "What resamples draw as a whole.", kGroupings, &grouping_name);
}

}  // namespace

py::object enum_member(const char* enumeration, std::string_view name) {
  return py::module_::import("prehend._core").attr(enumeration)(std::string(name));
}

void bind_enums(py::module_& core) {
  add_enum(core, "Outcome", "How a trial can end. The docstring of a member says what it means.",
           kOutcomes, &outcome_name, &outcome_meaning);
  add_enum(core, "PlanStatus", "How plan() or evaluate() ended.", kPlanStatuses, &plan_status_name);
  add_enum(core, "PlanCount", "What PlanResult.stages counts.", kPlanCounts, &plan_count_name);
  add_enum(core, "Stage", "The steps of a long call.", kStages, &stage_name);
  add_enum(core, "LiftEnd", "Whether a path goes on after the grasp, or why not.", kLiftEnds,
           &lift_end_name);
  add_enum(core, "Hint", "What may help where a plan found no grasp.", kHints, &hint_name);
  add_enum(core, "Accuracy", "How exact a plan is, and how long it takes.", kAccuracies,
           &accuracy_name);
  add_enum(core, "Material", "What surfaces are made of.", kMaterials, &material_name);
  add_enums_of_quality(core);
  add_enums_of_motion(core);
  add_enums_of_validation(core);
}

}  // namespace prehend::python
