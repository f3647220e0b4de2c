// The two checksums of HDF5.
#pragma once

#include "planner/results/datasets/hdf5/byte_cursor.h"

namespace prehend::hdf5 {

// Whether a wrong checksum is an error. libFuzzer's changes would end at the checksums, and never
// reach what stands behind them.
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
inline constexpr bool kChecksumsCount = false;
#else
inline constexpr bool kChecksumsCount = true;
#endif

// Of structures: lookup3 ("hashlittle") of Bob Jenkins, 2006, with the initial value 0.
std::uint32_t lookup3(Bytes bytes);

// Of values: Fletcher's sum of big-endian words of 16 bits, an odd byte being the upper one.
std::uint32_t fletcher32(Bytes bytes);

}  // namespace prehend::hdf5
