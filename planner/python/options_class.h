// Structs of options as Python classes, made from the declarations of their settings (settings.h):
// the same fields with the same defaults, all of them keywords of the constructor.
#pragma once

#include <pybind11/eigen.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <string_view>
#include <type_traits>

#include "sim/base/input_error.h"
#include "sim/base/joined.h"
#include "sim/base/named_enum.h"
#include "sim/base/pose.h"
#include "sim/base/settings.h"
#include "sim/base/visit_settings.h"

namespace prehend::python {

namespace py = pybind11;

// Sets each keyword as the attribute of that name. Throws TypeError for a name that is not a field.
void set_fields(const py::object& options, const py::dict& given);

// All that `_fields` of the class lists, by name.
py::dict fields_of(const py::object& options);

// "Name(field=value, ...)", with what `_fields` of the class lists.
std::string describe_fields(const py::object& options);

// Throws InputError that names the class and the field for a value outside of the range.
void check_range(const std::string& field, double value, const Range& range);

// "First turn of the hand [rad]; > 0.": meaning, unit and range.
std::string setting_doc(const Setting& setting);

// Lists a property as a field, with its type as it is written in Python: in `_fields` and
// `__annotations__`, from which the stub is made.
void add_field(const py::handle& type, const std::string& name, const std::string& type_name);

namespace detail {

// Setting number `number` of the options, which has this type.
template <typename Value, typename Options>
Value& nth_setting(Options& options, int number) {
  Value* found = nullptr;
  const auto look = [&](const Setting&, auto& value) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>,
                                 std::remove_const_t<Value>>) {
      if (number == 0) found = &value;
    }
    --number;
  };
  for_each_setting(options, SettingVisitor(look));
  return *found;
}

template <typename Enum>
Enum named_value(const std::string& field, const std::string& asked) {
  if (const std::optional<Enum> value = value_named<Enum>(asked)) return *value;
  throw InputError({.field = field,
                    .problem = "not one of " + joined(enum_names(Enum{}), ", "),
                    .value = asked});
}

// The type of a field as it is written in Python.
template <typename Value>
std::string type_in_python() {
  if constexpr (std::is_same_v<Value, bool>) {
    return "bool";
  } else if constexpr (std::is_enum_v<Value>) {
    return "Literal[\"" + joined(enum_names(Value{}), "\", \"") + "\"]";
  } else if constexpr (std::is_arithmetic_v<Value>) {
    return std::is_integral_v<Value> ? "int" : "float";
  } else if constexpr (prehend::detail::kIsOptional<Value>) {
    return "Optional[" + type_in_python<typename Value::value_type>() + "]";
  } else if constexpr (std::is_same_v<Value, Vector3>) {
    return "Union[_Floats, Sequence[float]]";
  } else {
    return std::string(Value::kAbout.name);
  }
}

template <typename Options, typename Value>
void add_property(py::class_<Options>& type, const Setting& setting, int number) {
  const std::string name(setting.name.name);
  const std::string field = std::string(Options::kAbout.name) + "." + name;
  const std::string doc = setting_doc(setting);
  if constexpr (std::is_enum_v<Value>) {
    type.def_property(
        name.c_str(),
        [number](const Options& self) { return name_of(nth_setting<const Value>(self, number)); },
        [number, field](Options& self, const std::string& asked) {
          nth_setting<Value>(self, number) = named_value<Value>(field, asked);
        },
        doc.c_str());
  } else if constexpr (std::is_arithmetic_v<Value>) {
    type.def_property(
        name.c_str(),
        [number](const Options& self) { return nth_setting<const Value>(self, number); },
        [number, field, range = setting.range](Options& self, Value value) {
          check_range(field, static_cast<double>(value), range);
          nth_setting<Value>(self, number) = value;
        },
        doc.c_str());
  } else {
    // By reference, so that a field of a nested struct can be set.
    type.def_property(
        name.c_str(),
        [number](const Options& self) -> const Value& {
          return nth_setting<const Value>(self, number);
        },
        [number](Options& self, const Value& value) { nth_setting<Value>(self, number) = value; },
        doc.c_str());
  }
}

}  // namespace detail

// Registers the struct, and those nested in it before it. Instances have keywords for all fields, a
// range is checked when a number is set, an enum is one of its names.
template <HasSettings Options>
py::class_<Options> settings_class(py::module_& module);

// The same, unless it is registered already.
template <HasSettings Options>
void bind_settings(py::module_& module) {
  const std::string name(Options::kAbout.name);
  if (!py::hasattr(module, name.c_str())) settings_class<Options>(module);
}

template <HasSettings Options>
py::class_<Options> settings_class(py::module_& module) {
  Options defaults;
  const auto bind_nested = [&](const Setting&, auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (HasSettings<Value>) {
      bind_settings<Value>(module);
    } else if constexpr (prehend::detail::kIsOptional<Value>) {
      bind_settings<typename Value::value_type>(module);
    }
  };
  for_each_setting(defaults, SettingVisitor(bind_nested));
  const std::string name(Options::kAbout.name);
  const std::string meaning(Options::kAbout.meaning);
  py::class_<Options> type(module, name.c_str(), meaning.c_str());
  type.def(py::init([](const py::kwargs& given) {
    Options options;
    set_fields(py::cast(&options, py::return_value_policy::reference), given);
    return options;
  }));
  type.def("__repr__", [](const py::object& self) { return describe_fields(self); });
  type.def("__copy__", [](const Options& self) { return Options(self); });
  type.def("__deepcopy__", [](const Options& self, const py::dict&) { return Options(self); });
  type.def(py::pickle([](const py::object& self) { return fields_of(self); },
                      [](const py::dict& fields) {
                        Options options;
                        set_fields(py::cast(&options, py::return_value_policy::reference), fields);
                        return options;
                      }));
  type.attr("_fields") = py::tuple();
  type.attr("__annotations__") = py::dict();
  int number = 0;
  const auto add = [&](const Setting& setting, auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    detail::add_property<Options, Value>(type, setting, number++);
    add_field(type, std::string(setting.name.name), detail::type_in_python<Value>());
  };
  for_each_setting(defaults, SettingVisitor(add));
  return type;
}

}  // namespace prehend::python
