// Whether a point is near the sampled surface, in constant time: a voxel grid.
#pragma once

#include <cstdint>
#include <vector>

#include "primitives/surface_sample.h"

namespace prehend {

class NearSurface {
 public:
  // Near means within `radius` (> 0) of a sample, to within a third of it.
  NearSurface(const std::vector<SurfacePoint>& points, double radius);

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
