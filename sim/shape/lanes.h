// Vectors of the processor, in single precision.
#pragma once

#include <cstddef>
#include <experimental/simd>

namespace prehend {

// As many numbers as the processor handles at once: 4 on every x86-64.
using Lanes = std::experimental::native_simd<float>;
inline constexpr std::size_t kLanes = Lanes::size();

inline Lanes load_lanes(const float* from) { return {from, std::experimental::element_aligned}; }

}  // namespace prehend
