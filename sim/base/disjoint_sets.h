// A partition of 0 .. n-1 into sets that can be merged (union-find).
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace prehend {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : parent_(n) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  // The smallest member of the set that holds the element: its representative.
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void merge(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    if (i < j) parent_[j] = i;
    if (j < i) parent_[i] = j;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace prehend
