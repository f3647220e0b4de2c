// A convex set of wrenches known by its support function: all that epsilon needs to see of it.
#pragma once

#include <vector>

#include "sim/quality/wrench.h"

namespace prehend {

// A non-empty, bounded convex set of wrenches.
class SupportMap {
 public:
  virtual ~SupportMap() = default;

  // A point of the set that lies farthest along `direction` (any length above 0). Must be
  // deterministic; among ties any one point may be returned, but the same one each time.
  virtual Wrench support(const Wrench& direction) const = 0;
};

// The convex hull of the columns of a matrix: Ferrari and Canny's L1 wrench space when the columns
// are those of contact_wrenches. Ties go to the first column.
class ColumnSupport final : public SupportMap {
 public:
  // An empty set, to be assigned before it is asked for anything.
  ColumnSupport() = default;
  explicit ColumnSupport(const Eigen::Ref<const Wrenches>& wrenches) { assign(wrenches); }

  // Makes it the hull of these columns, in the memory that it has. Throws InputError where there is
  // no column, or one that is not finite.
  void assign(const Eigen::Ref<const Wrenches>& wrenches);

  Wrench support(const Wrench& direction) const override;

 private:
  // Columns in blocks, one coordinate after the other, so that a block's products are vectorised.
  static constexpr int kBlock = 8;
  struct Block {
    double coordinate[6][kBlock];
  };
  std::vector<Block> blocks_;
};

}  // namespace prehend
