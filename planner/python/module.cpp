// The extension module prehend._core: what the Python package prehend is made of. What is bound
// here is private to the package: prehend/*.py makes its public face of it.

#include <pybind11/pybind11.h>

namespace prehend::python {

// The parts, each in a file of its name.
void bind_context(pybind11::module_& core);        // Cancellation, Progress
void bind_control(pybind11::module_& core);        // controllers, and runs with them
void bind_enums(pybind11::module_& core);          // enumerations by their names
void bind_fields(pybind11::module_& core);         // names of the fields of results
void bind_files(pybind11::module_& core);          // grasps.json, report, exports, pictures
void bind_learned_order(pybind11::module_& core);  // models that order candidates
void bind_options(pybind11::module_& core);        // of planning and of the quality measures
void bind_plan(pybind11::module_& core);           // decompose, propose, trial, plan, evaluate
void bind_quality(pybind11::module_& core);        // measures of many grasps at a time
void bind_robot(pybind11::module_& core);          // robots, their kinematics and its inverse
void bind_scene(pybind11::module_& core);          // scenes, meshes and what the library has
void bind_validation(pybind11::module_& core);     // scores against executed grasps
void bind_views(pybind11::module_& core);          // scenes of what depth cameras saw
void bind_world(pybind11::module_& core);          // worlds that move, their robots and bodies

// In errors.cpp.
void translate_errors();

}  // namespace prehend::python

PYBIND11_MODULE(_core, core) {
  using namespace prehend::python;  // NOLINT(google-build-using-namespace): the macro's function
  pybind11::options options;
  // The signatures that pybind11 writes name C++ types; _core.pyi has those that readers want.
  options.disable_function_signatures();
  core.doc() = "The C++ half of prehend. Use the package prehend, which is what is documented.";
  core.attr("__version__") = PREHEND_VERSION;
  translate_errors();
  bind_enums(core);
  bind_context(core);
  bind_learned_order(core);
  bind_options(core);
  bind_robot(core);
  bind_scene(core);
  bind_views(core);
  bind_plan(core);
  bind_files(core);
  bind_validation(core);
  bind_world(core);
  bind_control(core);
  bind_quality(core);
  bind_fields(core);
}
