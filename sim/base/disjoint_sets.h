// A partition of 0 .. n-1 into sets that can be merged (union-find).
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace prehend {

// Disjoint sets with path halving (Tarjan and van Leeuwen 1984). The root of each tree is the
// smallest member of its set, so that representatives do not depend on the order of the merges.
class DisjointSets {
 public:
  DisjointSets() = default;
  explicit DisjointSets(std::size_t n) { start(n); }

  // Starts with the n sets {0}, {1}, ... {n-1}, whatever there was before.
  void start(std::size_t n) {
    parent_.resize(n);
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  // Adds single elements until there are n, which takes no time where there are.
  void extend(std::size_t n) {
    while (parent_.size() < n) parent_.push_back(parent_.size());
  }

  // Makes i a set of its own again, where that is done to all members of its set.
  void separate(std::size_t i) { parent_[i] = i; }

  // The representative of the set that contains element i: its smallest member. Shortens the
  // searched path by half.
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  // Unites the sets that contain i and j.
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
