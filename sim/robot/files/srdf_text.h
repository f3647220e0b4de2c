// Robots as SRDF, which MoveIt reads beside a URDF.
#pragma once

#include <string>

#include "sim/robot/files/sphere_model.h"

namespace prehend {

// What SRDF adds to the URDF that urdf_text() writes of the same platform: a group of joints for
// each robot, its start, end effectors, pairs of links that may touch, and spheres. Source:
// http://wiki.ros.org/srdf/review
std::string srdf_text(const SphereModel& model);

}  // namespace prehend
