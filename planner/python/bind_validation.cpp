#include <pybind11/stl.h>
#include <string>
#include <tuple>

#include "planner/python/background.h"
#include "planner/show/validation/compare_executions.h"
#include "planner/show/validation/validation_page.h"
#include "planner/show/validation/validation_text.h"
#include "sim/base/input_error.h"
#include "sim/base/json/json_field.h"

namespace prehend::python {
namespace {

// The report as JSON, as a page and as a table. `groups` empty: those that suit.
std::tuple<py::bytes, py::bytes, py::bytes> compare_in_python(
    const std::string& file, const EvaluateOptions& evaluation, bool volumes,
    const std::string& groups, int resamples, const CallOptions& call) {
  CompareOptions options{evaluation, volumes, value_named<Grouping>(groups), resamples};
  if (!groups.empty() && !options.grouping) {
    throw InputError(
        {.field = "groups", .problem = "must be object, session, both or each", .value = groups});
  }
  std::string json;
  std::string page;
  std::string table;
  run_in_background(call, [&](const RunContext& context) {
    const ExecutedGrasps truth = read_executed_grasps(JsonFile(file), context);
    const ValidationReport report = compare_executions(truth, file, options, context);
    json = validation_json(report);
    page = validation_page(report);
    table = validation_table(report);
  });
  return {py::bytes(json), py::bytes(page), py::bytes(table)};
}

}  // namespace

void bind_validation(py::module_& core) { core.def("compare_executions", &compare_in_python); }

}  // namespace prehend::python
