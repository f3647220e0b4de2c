// The extension module prehend._core: what the Python package prehend is made of.

#include "planner/python/bindings.h"

PYBIND11_MODULE(_core, core) {
  using namespace prehend::python;  // NOLINT(google-build-using-namespace): the macro's function
  pybind11::options options;
  // The signatures that pybind11 writes name C++ types; _core.pyi has those that readers want.
  options.disable_function_signatures();
  core.doc() = "The C++ half of prehend. Use the package prehend, which is what is documented.";
  core.attr("__version__") = PREHEND_VERSION;
  translate_errors();
  bind_context(core);
  bind_options(core);
  bind_robot(core);
  bind_scene(core);
  bind_plan(core);
  bind_files(core);
  bind_truth(core);
  bind_world(core);
  bind_control(core);
  bind_quality(core);
}
