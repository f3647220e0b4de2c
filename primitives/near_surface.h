// A voxel grid that tells in constant time whether a point is near the sampled surface.
#pragma once

#include <cstdint>
#include <vector>

#include "primitives/surface_sample.h"

namespace prehend {

class NearSurface {
 public:
  // A point is near when it is within `radius` (> 0) of a sample. The edge of a voxel is a third of
  // the radius, which limits the accuracy.
  NearSurface(const std::vector<SurfacePoint>& points, double radius);

  // False for points outside the grid and points that are not finite.
  bool near(const Vector3& p_O) const;

 private:
  void mark(const Vector3& p_O, double radius);
  std::size_t index(const Eigen::Vector3i& cell) const;

  double cell_ = 0.0;
  Vector3 origin_ = Vector3::Zero();
  Eigen::Vector3i cells_ = Eigen::Vector3i::Zero();
  std::vector<std::uint8_t> marked_;
};

}  // namespace prehend
