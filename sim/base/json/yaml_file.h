// YAML files, read as JSON.
#pragma once

#include <filesystem>

#include "sim/base/json/json_field.h"

namespace prehend {

// Whether the name of a file says that it is YAML.
bool has_yaml_name(const std::filesystem::path& file);

// The first document of a YAML file. What stands without quotes is a number, true, false or null
// where it looks like one; a number with the tag of a unit (!degrees, !millimeters) is in SI.
// Throws InputError like the constructor of JsonFile, and for files that become too large where
// they refer to their own parts.
JsonFile read_yaml(const std::filesystem::path& file);
// As read_yaml, of text that was read from `file` already.
JsonFile parse_yaml(const std::filesystem::path& file, const std::string& text);

}  // namespace prehend
