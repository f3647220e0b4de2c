// Enumerations of C++ as Python classes of their names.
#pragma once

#include <pybind11/pybind11.h>
#include <string_view>

namespace prehend::python {

// The member with this name of an enumeration that bind_enums registers.
pybind11::object enum_member(const char* enumeration, std::string_view name);

}  // namespace prehend::python
