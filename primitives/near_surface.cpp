#include "primitives/near_surface.h"

#include <cmath>

// All voxels within the radius of a sample are marked once, so that a query only looks up one
// voxel. The phantom cost of every candidate primitive asks for many points (region.cpp), while the
// samples never change.
namespace prehend {

NearSurface::NearSurface(const std::vector<SurfacePoint>& points, double radius) {
  constexpr double kCellsPerRadius = 3.0;
  cell_ = radius / kCellsPerRadius;
  Bounds around;
  for (const SurfacePoint& s : points) {
    around.lower = around.lower.cwiseMin(s.p_O);
    around.upper = around.upper.cwiseMax(s.p_O);
  }
  if (points.empty()) return;
  const Vector3 margin = Vector3::Constant(radius + cell_);
  origin_ = around.lower - margin;
  cells_ = ((around.size() + 2.0 * margin) / cell_).array().ceil().cast<int>();
  marked_.assign(static_cast<std::size_t>(cells_.x()) * static_cast<std::size_t>(cells_.y()) *
                     static_cast<std::size_t>(cells_.z()),
                 0);
  for (const SurfacePoint& s : points) mark(s.p_O, radius);
}

bool NearSurface::near(const Vector3& p_O) const {
  const Vector3 at = (p_O - origin_) / cell_;
  // The comparison also turns away what is not finite.
  if (!((at.array() >= 0.0).all() && (at.array() < cells_.cast<double>().array()).all())) {
    return false;
  }
  return marked_[index(at.cast<int>())] != 0;
}

// Marks the voxels whose centres are within `radius` of the point, row by row.
void NearSurface::mark(const Vector3& p_O, double radius) {
  const Vector3 at = (p_O - origin_) / cell_;
  const double reach = radius / cell_;
  const Eigen::Vector3i low = (at.array() - reach).floor().cast<int>().max(0);
  const Eigen::Vector3i high = (at.array() + reach).floor().cast<int>().min(cells_.array() - 1);
  for (int z = low.z(); z <= high.z(); ++z) {
    for (int y = low.y(); y <= high.y(); ++y) {
      const double dy = y + 0.5 - at.y();
      const double dz = z + 0.5 - at.z();
      const double left = reach * reach - dy * dy - dz * dz;
      if (left < 0.0) continue;
      const std::size_t row = index({0, y, z});
      for (int x = low.x(); x <= high.x(); ++x) {
        const double dx = x + 0.5 - at.x();
        if (dx * dx <= left) marked_[row + static_cast<std::size_t>(x)] = 1;
      }
    }
  }
}

std::size_t NearSurface::index(const Eigen::Vector3i& cell) const {
  const auto nx = static_cast<std::size_t>(cells_.x());
  const auto ny = static_cast<std::size_t>(cells_.y());
  return (static_cast<std::size_t>(cell.z()) * ny + static_cast<std::size_t>(cell.y())) * nx +
         static_cast<std::size_t>(cell.x());
}

}  // namespace prehend
