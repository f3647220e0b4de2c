// Fields that are visited as in json_fields.h, as a Python dictionary with NumPy arrays.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <string_view>
#include <vector>

#include "planner/python/arrays.h"
#include "sim/base/named_enum.h"

namespace prehend::python {

template <typename T>
py::object in_python(const T& value) {
  if constexpr (NamedEnum<T>) {
    return py::str(std::string(name_of(value)));
  } else if constexpr (std::same_as<T, std::vector<std::vector<double>>>) {
    return to_array(value, value.empty() ? 0 : value.front().size());
  } else if constexpr (std::same_as<T, std::array<double, 2>>) {
    return py::make_tuple(value[0], value[1]);
  } else if constexpr (requires { to_array(value); }) {
    return to_array(value);
  } else {
    return py::cast(value);
  }
}

// The name in prehend/results.py of a field that has another one in files.
inline std::string name_in_python(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 7> kOther = {{
      {"X_object_hand", "X_OH"},
      {"X_world_hand", "X_WH"},
      {"X_object_moved", "X_OC"},
      {"weight", "holding"},
      {"squeeze", "sum_of_normals"},
      {"direction", "approach"},
      {"protocol", "procedure"},
  }};
  for (const auto& [in_files, other] : kOther) {
    if (name == in_files) return std::string(other);
  }
  return std::string(name);
}

// Has the functions of FieldWriter. What is left out or null in files is None here. Lists of
// objects are left out: in Python they are arrays by field, which have other names.
class DictionaryWriter {
 public:
  template <typename T>
  void operator()(std::string_view name, const T& value) {
    set(name, in_python(value));
  }
  template <typename T>
  void operator()(std::string_view name, const std::optional<T>& value) {
    set(name, value ? in_python(*value) : py::none());
  }
  void needs(std::string_view /*name*/) {}
  void require(std::string_view /*name*/, bool /*fits*/, const char* /*what*/) {}
  void unbounded(std::string_view name, double value) { (*this)(name, value); }
  template <typename T, typename Names>
  void named(std::string_view name, const T& value, const Names& names) {
    named_or_null(name, std::optional<T>(value), names);
  }
  template <typename T, typename Names>
  void named_or_null(std::string_view name, const std::optional<T>& value, const Names& names) {
    set(name, py::none());
    for (const auto& [word, meaning] : names) {
      if (value && meaning == *value) set(name, py::str(word));
    }
  }
  template <NamedEnum Enum>
  void counts(std::string_view name, const EnumArray<Enum, int>& counts) {
    py::dict some;
    for (const Enum value : kAll<Enum>) {
      if (counts[value] > 0) some[py::str(std::string(name_of(value)))] = counts[value];
    }
    set(name, some);
  }
  template <typename Visit>
  void object(std::string_view name, const Visit& visit) {
    DictionaryWriter inner;
    visit(inner);
    set(name, std::move(inner).fields());
  }
  template <typename Visit>
  void object_or_null(std::string_view name, bool there, const Visit& visit) {
    set(name, py::none());
    if (there) object(name, visit);
  }
  template <typename T, typename Visit>
  void part(std::string_view name, const std::optional<T>& value, const Visit& visit) {
    object_or_null(name, value.has_value(), [&](auto& inner) { visit(inner, *value); });
  }
  template <typename T, typename Visit>
  void objects(std::string_view /*name*/, const T& /*values*/, const Visit& /*visit*/) {}
  template <typename Make>
  void derived(std::string_view name, const Make& make) {
    (*this)(name, make());
  }
  template <typename T, typename Visit>
  void derived_part(std::string_view name, const std::optional<T>& value, const Visit& visit) {
    part(name, value, visit);
  }

  py::dict fields() && { return std::move(fields_); }

 private:
  void set(std::string_view name, const py::object& value) {
    fields_[py::str(name_in_python(name))] = value;
  }

  py::dict fields_;
};

}  // namespace prehend::python
