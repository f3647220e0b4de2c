// How C++ exceptions arrive in Python.
#pragma once

#include <pybind11/pybind11.h>

namespace prehend::python {

// From then on InputError and std::invalid_argument are prehend.InputError, Cancelled is
// prehend.Cancelled (prehend/_errors.py); what pybind11 knows stays as it is.
void translate_errors();

}  // namespace prehend::python
