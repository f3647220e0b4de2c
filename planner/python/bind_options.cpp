#include <pybind11/pybind11.h>

#include "planner/plan/plan_options.h"
#include "planner/python/options_class.h"
#include "planner/results/json_settings.h"
#include "sim/quality/quality.h"

namespace prehend::python {
namespace {

// Settings of earlier versions in a file are no errors, but a caller should know.
PlanOptions options_of_accuracy(const std::string& name_or_file) {
  std::vector<std::string> notes;
  PlanOptions options = read_accuracy(name_or_file, &notes);
  for (const std::string& note : notes) {
    if (PyErr_WarnEx(PyExc_UserWarning, note.c_str(), 2) != 0) throw py::error_already_set();
  }
  return options;
}

}  // namespace

void bind_options(py::module_& core) {
  bind_settings<PlanOptions>(core);
  bind_settings<EvaluateOptions>(core);
  bind_settings<WrenchSpaceOptions>(core);
  bind_settings<EpsilonOptions>(core);
  bind_settings<SetHullOptions>(core);
  bind_settings<ForceOptions>(core);
  core.def("plan_options", &options_of_accuracy);
}

}  // namespace prehend::python
