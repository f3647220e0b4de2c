// The bytes of the values of a data set, from wherever and however they are stored.
#pragma once

#include "planner/results/datasets/hdf5/data_set.h"

namespace prehend::hdf5 {

// The most bytes that the values of one data set may have in memory. Files are refused above it.
inline constexpr std::size_t kMostDecoded = std::size_t{1} << 28U;

// The number of values. Throws InputError for more of this size than the file can hold, before any
// memory is taken.
std::size_t value_count(const Image& image, const Extents& extents, std::size_t value_size);

// One value after the other, as the file has them; the fill value where none has been written.
// Throws damaged() and not_read().
std::vector<std::uint8_t> raw_values(const Image& image, const DataSet& data);

}  // namespace prehend::hdf5
