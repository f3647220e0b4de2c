#include "sim/quality/support.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>

#include "sim/base/input_error.h"
#include "sim/base/wide_lanes.h"

namespace prehend {
namespace {

// The largest sums of four columns, and in which blocks they are.
struct LargestSums {
  Doubles4 most;
  Longs4 at;
};

// The number of the column whose product with the direction is largest; of equal ones the first.
// Each lane sums over the coordinates in the same order, and keeps the largest sum that it has seen
// and in which block.
template <typename Block>
[[gnu::always_inline]] inline std::size_t farthest_in(const std::vector<Block>& blocks,
                                                      const double* direction) {
  constexpr std::size_t kLanes = 4;
  constexpr std::size_t kParts = sizeof(Block) / sizeof(double) / (6 * kLanes);
  const Doubles4 zero = {};
  std::array<LargestSums, kParts> found;
  found.fill({zero - std::numeric_limits<double>::infinity(), Longs4{}});
  Longs4 number = {};  // of the block
  for (const Block& block : blocks) {
    for (std::size_t part = 0; part < kParts; ++part) {
      Doubles4 sum = {};
      for (std::size_t i = 0; i < 6; ++i) {
        Doubles4 coordinates;
        std::memcpy(&coordinates, block.coordinate[i] + kLanes * part, sizeof(coordinates));
        sum += direction[i] * coordinates;
      }
      const Longs4 farther = sum > found[part].most;
      found[part].at = farther ? number : found[part].at;
      found[part].most = farther ? sum : found[part].most;
    }
    number += 1;
  }
  std::size_t best = 0;
  double largest = -std::numeric_limits<double>::infinity();
  for (std::size_t lane = 0; lane < kParts * kLanes; ++lane) {
    const double sum = found[lane / kLanes].most[lane % kLanes];
    const auto block = static_cast<std::size_t>(found[lane / kLanes].at[lane % kLanes]);
    const std::size_t column = block * kParts * kLanes + lane;
    if (sum < largest || (sum == largest && column > best)) continue;
    largest = sum;
    best = column;
  }
  return best;
}

template <typename Block>
PREHEND_FOR_AVX2 std::size_t farthest_with_avx2(const std::vector<Block>& blocks,
                                                const double* direction) {
  return farthest_in(blocks, direction);
}

}  // namespace

// Coordinates are stored in blocks of kBlock columns, coordinate by coordinate. Equal neighbours
// are stored once, and the empty places of the last block are filled with copies, so that every
// block can be processed as a whole.
void ColumnSupport::assign(const Eigen::Ref<const Wrenches>& wrenches) {
  if (wrenches.cols() == 0) throw InputError({.field = "wrenches", .problem = "none"});
  blocks_.clear();
  blocks_.reserve(static_cast<std::size_t>(wrenches.cols()) / kBlock + 1);
  int filled = kBlock;
  for (Eigen::Index j = 0; j < wrenches.cols(); ++j) {
    if (!wrenches.col(j).allFinite()) {
      throw InputError({.field = "wrenches[" + std::to_string(j) + "]", .problem = "not finite"});
    }
    // Frictionless contacts repeat their column: once is enough.
    if (j > 0 && wrenches.col(j) == wrenches.col(j - 1)) continue;
    if (filled == kBlock) {
      blocks_.emplace_back();
      // A block that is not full repeats its first column, which loses every tie to the first.
      for (int i = 0; i < 6; ++i) std::fill_n(blocks_.back().coordinate[i], kBlock, wrenches(i, j));
      filled = 0;
    }
    for (int i = 0; i < 6; ++i) blocks_.back().coordinate[i][filled] = wrenches(i, j);
    ++filled;
  }
}

Wrench ColumnSupport::support(const Wrench& direction) const {
  const std::size_t best = has_avx2() ? farthest_with_avx2(blocks_, direction.data())
                                      : farthest_in(blocks_, direction.data());
  const Block& block = blocks_[best / kBlock];
  Wrench point;
  for (int i = 0; i < 6; ++i) point[i] = block.coordinate[i][best % kBlock];
  return point;
}

}  // namespace prehend
