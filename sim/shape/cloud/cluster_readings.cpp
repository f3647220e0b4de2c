#include "sim/shape/cloud/cluster_readings.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"

namespace prehend {
namespace {

constexpr std::int64_t kHalfRange = std::int64_t{1} << 20;

// A cell holds a dozen readings of a surface and more. One that has a single one is noise, which
// would join what it lies between.
void drop_lone(std::vector<std::uint64_t>& cells, std::vector<std::size_t>& counts) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (counts[i] < 2) continue;
    cells[kept] = cells[i];
    counts[kept++] = counts[i];
  }
  cells.resize(kept);
  counts.resize(kept);
}

}  // namespace

std::array<std::int64_t, 3> ReadingClusters::cell_of(const Vector3& p) const {
  std::array<std::int64_t, 3> cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = std::floor(p[static_cast<Eigen::Index>(k)] / cell_);
    const auto most = static_cast<double>(kHalfRange - 2);
    cell[k] = static_cast<std::int64_t>(std::clamp(at, -most, most));
  }
  return cell;
}

ReadingClusters::Key ReadingClusters::key_of(const std::array<std::int64_t, 3>& cell) const {
  const auto part = [&](std::size_t k) { return static_cast<Key>(cell[k] + kHalfRange); };
  return part(2) << 42U | part(1) << 21U | part(0);
}

void ReadingClusters::add(const Vector3& p) { keys_.push_back(key_of(cell_of(p))); }

std::optional<std::size_t> ReadingClusters::find(Key key) const {
  const auto at = std::lower_bound(keys_.begin(), keys_.end(), key);
  if (at == keys_.end() || *at != key) return {};
  return static_cast<std::size_t>(at - keys_.begin());
}

void ReadingClusters::join(std::size_t least) {
  std::sort(keys_.begin(), keys_.end());
  std::vector<std::size_t> counts;
  std::vector<Key> cells;
  for (const Key key : keys_) {
    if (cells.empty() || cells.back() != key) {
      cells.push_back(key);
      counts.push_back(0);
    }
    ++counts.back();
  }
  drop_lone(cells, counts);
  keys_ = std::move(cells);
  DisjointSets sets(keys_.size());
  // Offsets add to keys component by component: no cell is at the end of the range.
  std::vector<Key> offsets;
  for (int z = -1; z <= 1; ++z) {
    for (int y = -1; y <= 1; ++y) {
      for (int x = -1; x <= 1; ++x) {
        const std::int64_t offset = z * (std::int64_t{1} << 42) + y * (std::int64_t{1} << 21) + x;
        if (offset > 0) offsets.push_back(static_cast<Key>(offset));
      }
    }
  }
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    for (const Key offset : offsets) {
      if (const auto other = find(keys_[i] + offset)) sets.merge(i, *other);
    }
  }
  std::vector<std::size_t> total(keys_.size(), 0);
  for (std::size_t i = 0; i < keys_.size(); ++i) total[sets.find(i)] += counts[i];
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < keys_.size(); ++i) {
    if (total[i] >= std::max<std::size_t>(least, 1)) roots.push_back(i);
    if (total[i] > 0 && total[i] < least) ++left_out_;
  }
  std::stable_sort(roots.begin(), roots.end(),
                   [&](std::size_t a, std::size_t b) { return total[a] > total[b]; });
  std::vector<int> number(keys_.size(), -1);
  for (const std::size_t root : roots) {
    number[root] = count();
    readings_.push_back(total[root]);
  }
  cluster_.resize(keys_.size());
  for (std::size_t i = 0; i < keys_.size(); ++i) cluster_[i] = number[sets.find(i)];
}

std::size_t ReadingClusters::readings(int cluster) const { return readings_[index(cluster)]; }

int ReadingClusters::cluster_at(const Vector3& p) const {
  const std::array<std::int64_t, 3> cell = cell_of(p);
  if (const auto here = find(key_of(cell)); here && cluster_[*here] >= 0) return cluster_[*here];
  for (std::int64_t z = -1; z <= 1; ++z) {
    for (std::int64_t y = -1; y <= 1; ++y) {
      for (std::int64_t x = -1; x <= 1; ++x) {
        const auto at = find(key_of({cell[0] + x, cell[1] + y, cell[2] + z}));
        if (at && cluster_[*at] >= 0) return cluster_[*at];
      }
    }
  }
  return -1;
}

}  // namespace prehend
