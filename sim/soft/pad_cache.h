// Pads that are made when they are first asked for.
#pragma once

#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "sim/soft/pad.h"

namespace prehend {

// The pad of a link. Its stiffness takes seconds to condense and is needed only where contacts are
// finite elements. Threads may share it.
class PadCache {
 public:
  // Divides the pad once, without its stiffness, so that what cannot be a pad is refused here:
  // throws as make_pad.
  PadCache(ProximityMesh link, PadShape shape);

  const ProximityMesh& link() const { return link_; }
  const PadShape& shape() const { return shape_; }

  // The same pad for equal options.
  std::shared_ptr<const Pad> get(const PadOptions& options) const;

 private:
  ProximityMesh link_;
  PadShape shape_;
  mutable std::mutex mutex_;
  mutable std::vector<std::pair<PadOptions, std::shared_ptr<const Pad>>> made_;
};

}  // namespace prehend
