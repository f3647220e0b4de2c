// The parts that the extension module prehend._core is put together from, each in a file of its
// name. What is bound here is private to the package: prehend/*.py makes its public face of it.
#pragma once

#include <pybind11/pybind11.h>

namespace prehend::python {

void bind_context(pybind11::module_& core);  // Cancellation, Progress
void bind_options(pybind11::module_& core);  // of planning and its parts
void bind_robot(pybind11::module_& core);    // robots, their kinematics and its inverse
void bind_scene(pybind11::module_& core);    // scenes, meshes and what the library has
void bind_plan(pybind11::module_& core);     // decompose, propose, trial, plan, evaluate
void bind_files(pybind11::module_& core);    // grasps.json, report, exports, pictures
void bind_truth(pybind11::module_& core);    // scores against executed grasps
void bind_world(pybind11::module_& core);    // worlds that move, their robots and bodies
void bind_control(pybind11::module_& core);  // controllers, and runs with them
void bind_quality(pybind11::module_& core);  // measures of many grasps at a time

// From then on InputError and std::invalid_argument are prehend.InputError, Cancelled is
// prehend.Cancelled (prehend/_errors.py); what pybind11 knows stays as it is.
void translate_errors();

}  // namespace prehend::python
