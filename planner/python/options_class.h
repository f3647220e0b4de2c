// Option structs as Python classes: the same fields with the same defaults, all of them keywords of
// the constructor.
#pragma once

#include <cmath>
#include <limits>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/base/input_error.h"
#include "sim/base/settings.h"

namespace prehend::python {

namespace py = pybind11;

// Sets each keyword as the attribute of that name. Throws TypeError for a name that is not a field.
void set_fields(const py::object& options, const py::kwargs& given);

// "Name(field=value, ...)", with what `_fields` of the class lists.
std::string describe_fields(const py::object& options);

// Throws InputError that names the class and the field for a value outside of the range.
void check_range(const std::string& field, double value, const Range& range);

// A field whose C++ type is an enum has its names as text in Python.
template <class Enum>
using EnumNames = std::vector<std::pair<std::string, Enum>>;

// Registers an options struct as a Python class: each call of field, number or choice adds one
// property. The destructor stores the names of all fields in the class attribute `_fields`.
template <class Options>
class OptionsClass {
 public:
  OptionsClass(py::module_& module, const char* name, const char* doc)
      : name_(name), class_(module, name, doc) {
    class_.def(py::init([](const py::kwargs& given) {
      Options options;
      set_fields(py::cast(&options, py::return_value_policy::reference), given);
      return options;
    }));
    class_.def("__repr__", [](const py::object& self) { return describe_fields(self); });
    class_.def("__copy__", [](const Options& self) { return Options(self); });
    class_.def("__deepcopy__", [](const Options& self, const py::dict&) { return Options(self); });
  }
  OptionsClass(const OptionsClass&) = delete;
  OptionsClass& operator=(const OptionsClass&) = delete;

  // Nothing can be done where Python has no memory left for this.
  // NOLINTNEXTLINE(bugprone-exception-escape)
  ~OptionsClass() { class_.attr("_fields") = py::tuple(fields_); }

  // Anything but a number: another options struct, an optional one, a flag.
  template <class Value>
  OptionsClass& field(const char* name, Value Options::*member, const char* doc) {
    class_.def_readwrite(name, member, doc);
    fields_.append(name);
    return *this;
  }

  // As field, where Python holds the value as another type.
  template <class Get, class Set>
  OptionsClass& property(const char* name, const Get& get, const Set& set, const char* doc) {
    class_.def_property(name, get, set, doc);
    fields_.append(name);
    return *this;
  }

  // A number that is one of the settings, whose range (settings.h) is checked when it is set. The
  // planner itself asserts it, which is right for C++ but would be a crash in Python.
  template <class Number>
  OptionsClass& number(const char* name, Number Options::*member, const char* doc) {
    return number(name, member, range_of(member), doc);
  }

  // As above, with its range.
  template <class Number>
  OptionsClass& number(const char* name, Number Options::*member, const Range& range,
                       const char* doc) {
    static_assert(std::is_arithmetic_v<Number>);
    class_.def_property(
        name, [member](const Options& self) { return self.*member; },
        [member, range, field = name_ + "." + name](Options& self, Number value) {
          check_range(field, static_cast<double>(value), range);
          self.*member = value;
        },
        doc);
    fields_.append(name);
    return *this;
  }

  // An enum, which in Python is one of the given names.
  template <class Enum>
  OptionsClass& choice(const char* name, Enum Options::*member, const EnumNames<Enum>& names,
                       const char* doc) {
    class_.def_property(
        name,
        [member, names](const Options& self) {
          for (const auto& [word, value] : names) {
            if (value == self.*member) return word;
          }
          return std::string();
        },
        [member, names, field = name_ + "." + name](Options& self, const std::string& asked) {
          std::string known;
          for (const auto& [word, value] : names) {
            if (word == asked) {
              self.*member = value;
              return;
            }
            known += (known.empty() ? "" : ", ") + word;
          }
          throw InputError({.field = field, .problem = "not one of " + known, .value = asked});
        },
        doc);
    fields_.append(name);
    return *this;
  }

 private:
  std::string name_;
  py::class_<Options> class_;
  py::list fields_;
};

}  // namespace prehend::python
