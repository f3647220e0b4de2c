// What is common to the things in some views: the support, and which readings are of which thing.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/run_context.h"
#include "sim/shape/cloud/reconstruct.h"
#include "sim/shape/cloud/support_plane.h"

namespace prehend {

struct PreparedViews {
  std::vector<DepthView> views;  // readings that are not finite or not positive are 0
  std::vector<double> noise;     // standard deviation of the readings of each view [m]
  double largest_noise = 0.0;
  std::optional<FoundPlane> plane;
  // P: on the support, z along its normal. Without a support: the axes of the first picture, z up.
  Pose X_PW = Pose::Identity();
  int count = 0;                          // of clusters; some may have no pixels
  int left_out = 0;                       // clusters that were too small
  std::vector<std::vector<int>> cluster;  // of each pixel of each view; -1: none
};

// Throws InputError for views without readings, with more than 25 million pixels, of cameras that
// are none, in millimetres, and of a plane alone; Cancelled.
PreparedViews prepare_views(const std::vector<DepthView>& views, const ReconstructOptions& options,
                            const RunContext& context);

}  // namespace prehend
