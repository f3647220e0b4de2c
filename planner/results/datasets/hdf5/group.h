// The members of a group.
#pragma once

#include <string>
#include <vector>

#include "planner/results/datasets/hdf5/object_header.h"

namespace prehend::hdf5 {

// More are refused: no set of grasps has so many.
inline constexpr std::size_t kMostLinks = 1000;

struct Link {
  std::string name;
  std::uint64_t object = kNowhere;  // its header; nowhere: the link leads to a path or another file
};

// Of symbol tables, of link messages and of fractal heaps; none for what is no group. Throws
// damaged() and not_read().
bool is_group(const Messages& header);
std::vector<Link> links_of(const Image& image, const Messages& header);

}  // namespace prehend::hdf5
