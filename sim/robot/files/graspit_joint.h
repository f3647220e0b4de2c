// Joints and degrees of freedom of GraspIt! robots.
#pragma once

#include <string>
#include <vector>

#include "sim/base/xml/xml_file.h"
#include "sim/robot/robot.h"

namespace prehend {

// The joint of an element <joint>: four parameters of Denavit and Hartenberg [mm, deg], of which
// theta (revolute) or d (prismatic) is driven. Its name, parent and chain are left as they are;
// X_PJ is the identity. `dofs`: how many degrees of freedom there are. Limits the wrong way round
// are turned, with a note. Throws InputError with the line.
Joint read_graspit_joint(const XmlElement& element, int dofs, std::vector<std::string>& notes);

// Sets type, velocity, effort and limits of degree of freedom `dof` from its element <dof>, after
// all its joints have been read; the effort goes to its joints. Throws InputError with the line.
void read_graspit_dof(const XmlElement& element, int dof, Robot& robot);

}  // namespace prehend
