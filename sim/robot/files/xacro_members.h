// Parts of the lists, maps and texts of xacro files, which mostly come from YAML files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim/base/json/json_field.h"
#include "sim/robot/files/xacro_expression.h"

namespace prehend {

// The map that a value is; null where it is none.
const std::map<std::string, XacroValue>* as_map(const XacroValue& value);

// The part of a list or text by a whole number, negative from the end, or of a map by its key.
// Throws InputError without a place, as do those below.
XacroValue element_of(const XacroValue& from, const XacroValue& which);

// What a map holds under a name, written as map.name.
XacroValue member_of(const XacroValue& from, const std::string& name);

// A method of Python: get and keys of maps, lower, upper, strip, startswith, endswith, replace and
// split of texts.
XacroValue method_of(const XacroValue& from, const std::string& name,
                     const std::vector<XacroValue>& arguments);

// The value that stands in a file of data.
XacroValue xacro_value_of(const JsonField& field);

}  // namespace prehend
