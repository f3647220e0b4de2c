#include "planner/python/options_class.h"

#include <sstream>

namespace prehend::python {

void set_fields(const py::object& options, const py::dict& given) {
  const py::object type = py::type::of(options);
  const py::tuple fields = type.attr("_fields");
  for (const auto& [name, value] : given) {
    if (!fields.contains(name)) {
      throw py::type_error(
          py::str("{} has no field {} (fields: {})")
              .format(type.attr("__name__"), name, py::str(", ").attr("join")(fields))
              .cast<std::string>());
    }
    py::setattr(options, name, value);
  }
}

py::dict fields_of(const py::object& options) {
  py::dict values;
  for (const py::handle name : py::tuple(py::type::of(options).attr("_fields"))) {
    values[name] = py::getattr(options, name);
  }
  return values;
}

std::string describe_fields(const py::object& options) {
  const py::object type = py::type::of(options);
  std::string text;
  for (const py::handle name : py::tuple(type.attr("_fields"))) {
    text += (text.empty() ? "" : ", ") + name.cast<std::string>() + "=" +
            py::repr(py::getattr(options, name)).cast<std::string>();
  }
  return type.attr("__name__").cast<std::string>() + "(" + text + ")";
}

void check_range(const std::string& field, double value, const Range& range) {
  if (range.contains(value)) return;
  std::ostringstream shown;
  shown << value;
  throw InputError({.field = field, .problem = range.words(), .value = shown.str()});
}

std::string setting_doc(const Setting& setting) {
  std::string doc(setting.meaning);
  const std::string range = setting.range.interval();
  std::string limits = setting.unit.empty() ? "" : " [" + std::string(setting.unit) + "]";
  if (!range.empty()) limits += (limits.empty() ? " " : ", ") + range;
  return limits.empty() ? doc : doc.substr(0, doc.size() - 1) + "; " + limits.substr(1) + ".";
}

void add_field(const py::handle& type, const std::string& name, const std::string& type_name) {
  const py::dict types = type.attr("__annotations__");
  types[py::str(name)] = type_name;
  type.attr("_fields") = py::tuple(types);
}

}  // namespace prehend::python
