#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>

#include "sim/base/input_error.h"
#include "sim/base/run_context.h"

namespace prehend::python {
namespace {

namespace py = pybind11;

// Sets a Python exception of a class of prehend/_errors.py, made from `problem` and the keywords.
void raise(const char* type, const std::string& problem, const py::dict& keywords = {}) {
  const py::object error = py::module_::import("prehend._errors").attr(type);
  PyErr_SetObject(error.ptr(), error(problem, **keywords).ptr());
}

template <class Error>
void raise_input_error(const Error& error) {
  if constexpr (requires { error.field(); }) {
    py::dict parts;
    parts["file"] = error.file();
    parts["field"] = error.field();
    parts["value"] = error.value();
    raise("InputError", error.problem(), parts);
  } else {
    raise("InputError", error.what());
  }
}

}  // namespace

void translate_errors() {
  // pybind11 hands the pointer over by value.
  // NOLINTNEXTLINE(performance-unnecessary-value-param)
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      // InputError is a std::invalid_argument, so it must be caught first: only then its parts are
      // kept.
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Cancelled& error) {
      raise("Cancelled", error.what());
    } catch (const InputError& error) {
      raise_input_error(error);
    } catch (const std::system_error& error) {
      const py::tuple arguments = py::make_tuple(error.code().value(), error.what());
      PyErr_SetObject(PyExc_OSError, arguments.ptr());
    } catch (const std::length_error& error) {  // of a container that no memory could hold
      PyErr_SetString(PyExc_MemoryError, error.what());
    } catch (const std::invalid_argument& error) {
      raise("InputError", error.what());
    }
  });
}

}  // namespace prehend::python
