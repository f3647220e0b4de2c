#include <pybind11/pybind11.h>
#include <string>

#include "planner/python/enum_names.h"
#include "sim/base/run_context.h"

namespace prehend::python {

namespace py = pybind11;

void bind_context(py::module_& core) {
  py::class_<Cancellation>(
      core, "Cancellation",
      "A flag that is raised once and stays up. Keep it, hand it to a long call, and call "
      "request() "
      "from any thread, or from the call's own progress callback, to end that call early.")
      .def(py::init<>())
      .def("request", &Cancellation::request, "Raises the flag.")
      .def_property_readonly("requested", &Cancellation::requested, "Whether it was raised.");
  py::class_<Progress>(core, "Progress", "How far a stage of a long call is.")
      .def_property_readonly(
          "stage", [](const Progress& self) { return enum_member("Stage", name_of(self.stage)); },
          "Stage: what is being done.")
      .def_readonly("done", &Progress::done, "Pieces that are done: trials, paths, ...")
      .def_readonly("total", &Progress::total, "Of so many.")
      .def_readonly("stable", &Progress::stable, "Of the trials done, those whose grasp holds.")
      .def("__repr__", [](const Progress& self) {
        return "Progress(stage='" + std::string(name_of(self.stage)) +
               "', done=" + std::to_string(self.done) + ", total=" + std::to_string(self.total) +
               ", stable=" + std::to_string(self.stable) + ")";
      });
}

}  // namespace prehend::python
