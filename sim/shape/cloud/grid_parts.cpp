#include "sim/shape/cloud/grid_parts.h"

#include <algorithm>
#include <cmath>

namespace prehend {
namespace {

// Numbers the connected parts of the corners that are inside (or outside); -1 for the others.
int number_parts(const DistanceGrid& grid, bool inside, std::vector<int>& part) {
  part.assign(grid.value.size(), -1);
  const std::array<std::size_t, 3> step = {1, grid.at(0, 1, 0), grid.at(0, 0, 1)};
  const auto belongs = [&](std::size_t i) { return (grid.value[i] < 0.0F) == inside; };
  std::vector<std::size_t> open;
  int count = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] >= 0 || !belongs(i)) continue;
    open.push_back(i);
    part[i] = count;
    while (!open.empty()) {
      const std::size_t here = open.back();
      open.pop_back();
      const std::array<std::size_t, 3> at = {here % step[1], here % step[2] / step[1],
                                             here / step[2]};
      for (std::size_t k = 0; k < 3; ++k) {
        const auto visit = [&](std::size_t next) {
          if (part[next] >= 0 || !belongs(next)) return;
          part[next] = count;
          open.push_back(next);
        };
        if (at[k] > 0) visit(here - step[k]);
        if (at[k] + 1 < index(grid.size[k])) visit(here + step[k]);
      }
    }
    ++count;
  }
  return count;
}

}  // namespace

void keep_seen_parts(DistanceGrid& grid, const std::vector<Vector3>& points) {
  std::vector<int> part;
  const int count = number_parts(grid, true, part);
  std::vector<std::size_t> votes(index(count), 0);
  for (const Vector3& p : points) {
    const Vector3 at = (p - grid.lower) / grid.edge;
    int found = -1;
    for (int c = 0; c < 8 && found < 0; ++c) {
      std::array<int, 3> corner{};
      bool within = true;
      for (std::size_t k = 0; k < 3; ++k) {
        corner[k] = static_cast<int>(std::floor(at[static_cast<Eigen::Index>(k)])) + (c >> k & 1);
        within = within && corner[k] >= 0 && corner[k] < grid.size[k];
      }
      if (within) found = part[grid.at(corner[0], corner[1], corner[2])];
    }
    if (found >= 0) ++votes[index(found)];
  }
  const std::size_t most = votes.empty() ? 0 : *std::max_element(votes.begin(), votes.end());
  const auto outside = static_cast<float>(grid.edge);
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] < 0) continue;
    const std::size_t own = votes[index(part[i])];
    if (own == 0 || (own < most && own * 10 < points.size())) grid.value[i] = outside;
  }
  number_parts(grid, false, part);
  for (std::size_t i = 0; i < part.size(); ++i) {
    // The first corner of the grid is at its border.
    if (part[i] >= 0 && part[i] != part[0]) grid.value[i] = -outside;
  }
}

}  // namespace prehend
