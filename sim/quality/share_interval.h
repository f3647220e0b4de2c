// How well a share is known from a number of tries.
#pragma once

#include "sim/quality/interval.h"

namespace prehend {

// Quantiles of the normal distribution, for intervals that contain the true value with a
// probability of 90 % and of 95 %.
inline constexpr double kQuantile90 = 1.6448536269514722;
inline constexpr double kQuantile95 = 1.959963984540054;

// The interval that contains the true share of `held` out of `count` tries (Wilson, "Probable
// inference, the law of succession, and statistical inference", 1927); from 0 to 1 where there are
// no tries.
Interval share_interval(int held, int count, double quantile);

}  // namespace prehend
