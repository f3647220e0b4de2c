// Expands robot files that are written with xacro. Source: https://wiki.ros.org/xacro
#pragma once

#include "sim/base/xml/xml_file.h"
#include "sim/robot/files/package_folders.h"

namespace prehend {

// Whether the file has elements of xacro.
bool has_xacro(const XmlFile& file);

// The file that the xacro file stands for: properties, macros with parameters and blocks, includes,
// conditions, arguments, elements and attributes of computed names, YAML files of data and
// expressions (xacro_expression.h) are replaced by what they say. Elements keep the place where
// they were written. Throws InputError that names it: for what is none of these, such as
// environment variables; for macros, conditions and properties that use each other without end, and
// files that grow to more than XmlMaker takes.
XmlFile expanded_xacro(const XmlFile& file, const ForeignRobotOptions& options);

}  // namespace prehend
