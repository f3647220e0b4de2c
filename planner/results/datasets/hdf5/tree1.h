// B-trees of version 1: the names of a group, or the chunks of a data set.
#pragma once

#include <vector>

#include "planner/results/datasets/hdf5/image.h"

namespace prehend::hdf5 {

enum class Tree1Type : std::uint8_t { group = 0, chunks = 1 };

struct Tree1Entry {
  Bytes key;  // the one before the child
  std::uint64_t child = kNowhere;
};

// What the leaves point to, in no order; nothing where there is no tree. Throws damaged(), also for
// more than `most` of them.
std::vector<Tree1Entry> tree1_entries(const Image& image, std::uint64_t root, Tree1Type type,
                                      std::size_t key_size, std::size_t most);

}  // namespace prehend::hdf5
