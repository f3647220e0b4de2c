// Robots as XRDF, which Isaac and cuRobo read beside a URDF.
#pragma once

#include <string>

#include "sim/robot/files/sphere_model.h"

namespace prehend {

// What XRDF 1.0 adds to the URDF that urdf_text() writes of the same platform: where joints start,
// limits of acceleration and jerk, tool frames, spheres, and pairs of links that may touch. No
// robot file states jerk: it is 500 rad/s^3 or m/s^3, and an acceleration that is not known 15
// rad/s^2 or m/s^2, as in the robot files of cuRobo. Source of the format:
// https://nvidia-isaac-ros.github.io/concepts/manipulation/xrdf.html
std::string xrdf_text(const SphereModel& model);

}  // namespace prehend
