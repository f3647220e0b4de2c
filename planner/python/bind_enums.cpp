#include <algorithm>
#include <pybind11/pybind11.h>
#include <string>

#include "planner/plan/accuracy.h"
#include "planner/plan/advice.h"
#include "planner/plan/path/lift_object.h"
#include "planner/plan/plan_result.h"
#include "planner/python/enum_names.h"
#include "planner/show/validation/bootstrap.h"
#include "planner/show/validation/open_hand.h"
#include "sim/base/material.h"
#include "sim/base/named_enum.h"
#include "sim/base/run_context.h"
#include "sim/motion/control/run_controlled.h"
#include "sim/motion/step_world.h"
#include "sim/quality/contact.h"
#include "sim/quality/epsilon.h"
#include "sim/quality/forces.h"
#include "sim/trial/outcome.h"

namespace prehend::python {
namespace {

namespace py = pybind11;

// A class of strings, one for each value; a space in a name is an underscore in its member. What a
// value means, where that is given, is the docstring of its member.
template <NamedEnum Enum>
void add_enum(py::module_& core, const char* name, const char* doc,
              std::string_view (*meaning_of)(Enum) = nullptr) {
  py::list members;
  for (const Enum value : kAll<Enum>) {
    const std::string text(name_of(value));
    std::string member = text;
    std::replace(member.begin(), member.end(), ' ', '_');
    members.append(py::make_tuple(member, text));
  }
  const py::module_ builtins = py::module_::import("builtins");
  const py::object made = py::module_::import("enum").attr("Enum")(
      name, members, py::arg("module") = "prehend._core", py::arg("type") = builtins.attr("str"));
  // Shown as the string that it is, as enum.StrEnum of later Python does.
  made.attr("__str__") = builtins.attr("str").attr("__str__");
  made.attr("__doc__") = doc;
  if (meaning_of != nullptr) {
    for (const Enum value : kAll<Enum>) {
      made(std::string(name_of(value))).attr("__doc__") = std::string(meaning_of(value));
    }
  }
  core.attr(name) = made;
}

}  // namespace

py::object enum_member(const char* enumeration, std::string_view name) {
  return py::module_::import("prehend._core").attr(enumeration)(std::string(name));
}

void bind_enums(py::module_& core) {
  add_enum<Outcome>(core, "Outcome",
                    "How a trial can end. The docstring of a member says what it means.",
                    &outcome_meaning);
  add_enum<PlanStatus>(core, "PlanStatus", "How plan() or evaluate() ended.");
  add_enum<PlanCount>(core, "PlanCount", "What PlanResult.stages counts.");
  add_enum<Stage>(core, "Stage", "The steps of a long call.");
  add_enum<LiftEnd>(core, "LiftEnd", "Whether a path goes on after the grasp, or why not.");
  add_enum<Hint>(core, "Hint", "What may help where a plan found no grasp.");
  add_enum<Accuracy>(core, "Accuracy", "How exact a plan is, and how long it takes.");
  add_enum<Material>(core, "Material", "What surfaces are made of.");
  add_enum<ContactModel>(core, "ContactModel", "What a contact can exert.");
  add_enum<EpsilonStatus>(core, "EpsilonStatus", "How the search for epsilon ended.");
  add_enum<ForceOutcome>(core, "ForceOutcome", "What is known about balancing forces.");
  add_enum<StepOutcome>(core, "StepOutcome", "How a step of a world ended.");
  add_enum<ControlOutcome>(core, "ControlOutcome", "How a run with controllers ended.");
  add_enum<ObjectPlace>(core, "ObjectPlace", "Where the object is in the open hand.");
  add_enum<Grouping>(core, "Grouping", "What resamples draw as a whole.");
}

}  // namespace prehend::python
