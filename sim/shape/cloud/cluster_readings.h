// Which readings belong to which thing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "sim/base/pose.h"

namespace prehend {

// The cells of a grid that readings lie in, joined where they touch.
class ReadingClusters {
 public:
  // Edge of the cells [m].
  explicit ReadingClusters(double cell) : cell_(cell) {}

  void add(const Vector3& p);
  // Joins what was added: the cluster of each cell, those with the most readings first, those with
  // fewer than `least` readings left out. Cells with a single reading are noise: they join nothing.
  void join(std::size_t least);

  int count() const { return static_cast<int>(readings_.size()); }
  std::size_t readings(int cluster) const;  // that were added to it
  int left_out() const { return left_out_; }
  // The cluster of the cell of `p`, or of one that touches it; -1: none.
  int cluster_at(const Vector3& p) const;

 private:
  using Key = std::uint64_t;
  Key key_of(const std::array<std::int64_t, 3>& cell) const;
  std::array<std::int64_t, 3> cell_of(const Vector3& p) const;
  std::optional<std::size_t> find(Key key) const;

  double cell_;
  std::vector<Key> keys_;     // of readings; once joined, of cells, sorted
  std::vector<int> cluster_;  // of cells
  std::vector<std::size_t> readings_;
  int left_out_ = 0;
};

}  // namespace prehend
