// How fast a joint gets between two samples of its motion.
#pragma once

namespace prehend {

// The largest magnitudes on the cubic Hermite polynomial between two samples.
struct CubicPeaks {
  double velocity = 0.0;
  double acceleration = 0.0;
};

// Of the cubic that covers `change` in `seconds` (> 0), from velocity v_from to v_to. The
// acceleration is linear in time, so it is largest at an end; the velocity is largest at an end or
// where the acceleration is 0.
CubicPeaks cubic_peaks(double change, double v_from, double v_to, double seconds);

}  // namespace prehend
