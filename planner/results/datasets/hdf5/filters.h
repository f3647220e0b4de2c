// The filters through which chunks are stored.
#pragma once

#include "planner/results/datasets/hdf5/data_set.h"

namespace prehend::hdf5 {

// The bytes of a chunk before the filters, as many as `size`, except those whose bit in `mask` is
// set. Takes no more memory than two such chunks. Throws damaged(): for another size, a checksum
// that is wrong, or what deflate cannot have made.
std::vector<std::uint8_t> unfiltered(Bytes stored, const std::vector<Filter>& filters,
                                     std::uint64_t mask, std::size_t size);

}  // namespace prehend::hdf5
