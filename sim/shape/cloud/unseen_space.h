// The space that depth cameras do not know of, because something was in front of it.
#pragma once

#include <utility>
#include <vector>

#include "sim/base/pose.h"
#include "sim/shape/cloud/depth_view.h"

namespace prehend {

class UnseenSpace {
 public:
  explicit UnseenSpace(std::vector<DepthView> views) : views_(std::move(views)) {}

  // Whether the point lies more than a centimetre behind a reading, and no view saw as far as it.
  // Pixels without a reading, and views that do not look there, say nothing.
  bool contains(const Vector3& p_W) const;

 private:
  std::vector<DepthView> views_;
};

}  // namespace prehend
