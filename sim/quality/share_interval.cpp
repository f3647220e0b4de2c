#include "sim/quality/share_interval.h"

#include <algorithm>
#include <cmath>

namespace prehend {

Interval share_interval(int held, int count, double quantile) {
  if (count == 0) return {0.0, 1.0};
  const double n = count;
  const double p = held / n;
  const double z2 = quantile * quantile;
  const double middle = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half = quantile / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace prehend
