// Robots and bodies in the XML format of OpenRAVE (Diankov 2010, "Automated Construction of Robotic
// Manipulation Programs"; the format as its reader takes it).
#pragma once

#include "sim/base/xml/xml_file.h"

namespace prehend {

// Whether the outermost element is one of OpenRAVE's: <KinBody>, <Robot> with such bodies, or an
// <Environment>. Tags are compared without regard to case, as OpenRAVE does.
bool is_openrave(const XmlFile& file);

// The only robot of the file as URDF says it: bodies with their boxes, balls, cylinders and meshes,
// joints that turn or slide, mimics that are linear, files that are named (`file`, beside the file
// that names them), and a frame "NAME_tcp" for each manipulator. Bodies that no joint joins to the
// first one are left out. Elements keep the place where they were written. Throws InputError that
// names it: other joints and shapes, several robots, files that name each other.
XmlFile urdf_of_openrave(const XmlFile& file);

}  // namespace prehend
