// Uniform random numbers that are the same with every standard library.
#pragma once

#include <random>

namespace prehend {

// In [0, 1).
inline double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11) * 0x1.0p-53;
}

}  // namespace prehend
