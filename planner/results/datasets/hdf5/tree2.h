// B-trees of version 2: records of one size, in nodes of one size.
#pragma once

#include <vector>

#include "planner/results/datasets/hdf5/image.h"

namespace prehend::hdf5 {

enum class Tree2Type : std::uint8_t { link_names = 5, chunks = 10, filtered_chunks = 11 };

// All records, in no order; nothing where there is no tree. Throws damaged().
std::vector<Bytes> tree2_records(const Image& image, std::uint64_t header, Tree2Type type);

}  // namespace prehend::hdf5
