// Motion along straight lines of joint space, with a stop at each corner.
#pragma once

#include <vector>

#include "sim/motion/control/time_path.h"

namespace prehend {

// The motion that time_path describes for PathKind::corners. `sample_time` in s. Throws InputError
// when it would take too many samples.
TimedPath time_corners(const std::vector<std::vector<double>>& waypoints, const JointLimits& limits,
                       double sample_time);

}  // namespace prehend
