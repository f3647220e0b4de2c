#include "sim/quality/support.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

#include "sim/base/input_error.h"

namespace prehend {

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

// Compares the products of all columns with the direction. The eight lanes of a block are summed
// independently of each other, each over the coordinates in the same order, so that the compiler
// can vectorise the loops without changing results. Only a larger product replaces the best one:
// ties go to the first column.
Wrench ColumnSupport::support(const Wrench& direction) const {
  double best = -std::numeric_limits<double>::infinity();
  const Block* best_block = &blocks_.front();
  int best_lane = 0;
  for (const Block& block : blocks_) {
    double value[kBlock] = {};
    for (int i = 0; i < 6; ++i) {
      for (int k = 0; k < kBlock; ++k) value[k] += direction[i] * block.coordinate[i][k];
    }
    for (int k = 0; k < kBlock; ++k) {
      if (value[k] > best) {
        best = value[k];
        best_block = &block;
        best_lane = k;
      }
    }
  }
  Wrench point;
  for (int i = 0; i < 6; ++i) point[i] = best_block->coordinate[i][best_lane];
  return point;
}

}  // namespace prehend
