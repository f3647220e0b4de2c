// Robots as XRDF, which Isaac and cuRobo read beside a URDF.
#pragma once

#include <string>

#include "sim/robot/files/sphere_model.h"

namespace prehend {

// What XRDF 1.0 adds to the URDF that urdf_text() writes of the same platform: where joints start,
// limits of acceleration and jerk, tool frames, spheres, and pairs of links that may touch. Jerk,
// and accelerations that are not known, are those that cuRobo takes for others: 500 and 15 rad/s
// (or m/s) to the third and second power of a second. Source:
// https://nvidia-isaac-ros.github.io/concepts/manipulation/xrdf.html
std::string xrdf_text(const SphereModel& model);

}  // namespace prehend
