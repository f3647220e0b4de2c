// Wrenches so large or so small that products of their coordinates leave the range of doubles.
#pragma once

#include "sim/quality/wrench.h"

namespace prehend {

// The e for which the largest coordinate times 2^-e is between 1/2 and 1, or 0 where that is not
// needed: where the coordinate is 0, not finite, or between 2^-150 and 2^150, so that its sixth
// power is a normal double.
int excess_exponent(const Eigen::Ref<const Wrenches>& wrenches);

// Wrenches times 2^exponent: exact, but for coordinates that fall below the smallest double.
Wrenches times_power_of_two(const Eigen::Ref<const Wrenches>& wrenches, int exponent);

}  // namespace prehend
