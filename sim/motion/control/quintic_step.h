// The smooth way from 0 to 1 that motions from rest to rest follow.
#pragma once

#include <algorithm>

namespace prehend {

// From 0 at s = 0 to 1 at s = 1, with rate and acceleration 0 at both ends; outside it stays at 0
// and 1.
inline double quintic_step(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * s * (10.0 + s * (-15.0 + 6.0 * s));
}

}  // namespace prehend
