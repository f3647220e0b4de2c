// Motion along a smooth curve of joint space, without a stop.
#pragma once

#include "sim/motion/control/joint_curve.h"
#include "sim/motion/control/time_path.h"

namespace prehend {

// The fastest motion along the curve from rest to rest that time_path describes for
// PathKind::smooth. `sample_time` in s. Throws InputError when it would take too many samples.
TimedPath time_curve(const JointCurve& curve, const JointLimits& limits, double sample_time);

}  // namespace prehend
