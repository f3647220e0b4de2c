#include "sim/motion/control/cubic_peaks.h"

#include <algorithm>
#include <cmath>

namespace prehend {

CubicPeaks cubic_peaks(double change, double v_from, double v_to, double seconds) {
  const double mean = change / seconds;
  const double a_from = (6.0 * mean - 4.0 * v_from - 2.0 * v_to) / seconds;
  const double a_to = (-6.0 * mean + 2.0 * v_from + 4.0 * v_to) / seconds;
  CubicPeaks peaks{std::max(std::abs(v_from), std::abs(v_to)),
                   std::max(std::abs(a_from), std::abs(a_to))};
  if ((a_from < 0.0 && a_to > 0.0) || (a_from > 0.0 && a_to < 0.0)) {
    // From a_from to 0 the velocity changes by the area of a triangle.
    const double turn = seconds * (a_from / (a_from - a_to));
    peaks.velocity = std::max(peaks.velocity, std::abs(v_from + 0.5 * a_from * turn));
  }
  return peaks;
}

}  // namespace prehend
