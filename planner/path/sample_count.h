// How a duration is divided into samples.
#pragma once

namespace prehend {

// A motion from stop to stop is stretched to this [s]: times of its samples stay apart where they
// are written in nanoseconds, and velocities differ by more than rounding.
inline constexpr double kShortestMotion = 1e-6;

// The smallest number of equal steps, at least 1, none of them longer than `sample_time`. Throws
// InputError for more than ten million.
int step_count(double duration, double sample_time);

}  // namespace prehend
