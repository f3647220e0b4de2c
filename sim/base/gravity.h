// The weight of things.
#pragma once

namespace prehend {

// Standard gravity (3rd General Conference on Weights and Measures, 1901) [m/s^2].
inline constexpr double kStandardGravity = 9.80665;

}  // namespace prehend
