// Order statistics: the fits take medians and tails of distances in every step.
#pragma once

#include <cstddef>
#include <span>

namespace prehend {

// The value at this place (< values.size()) of the ascending order; 0 is the smallest. Reorders
// `values`. With a NaN among them the result is any of the values.
double value_at_place(std::span<double> values, std::size_t place);

// The place of the q-quantile of `count` (> 0) values, q in [0, 1].
std::size_t quantile_place(std::size_t count, double q);

// The q-quantile of the values, q in [0, 1] (0: smallest, 0.5: median). Reorders `values`, which
// must not be empty.
double quantile(std::span<double> values, double q);

}  // namespace prehend
