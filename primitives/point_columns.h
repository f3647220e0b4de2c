// Surface points by coordinate, so that loops over many points use vector instructions.
#pragma once

#include <span>

#include "primitives/surface_sample.h"

namespace prehend {

// A row for each point.
struct PointColumns {
  Eigen::MatrixX3d p;  // points
  Eigen::MatrixX3d n;  // their unit normals

  Eigen::Index size() const { return p.rows(); }
};

// The points, moved by -center.
inline PointColumns columns_about(const Vector3& center, std::span<const SurfacePoint> points) {
  const auto count = static_cast<Eigen::Index>(points.size());
  PointColumns columns{Eigen::MatrixX3d(count, 3), Eigen::MatrixX3d(count, 3)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const SurfacePoint& s = points[static_cast<std::size_t>(i)];
    columns.p.row(i) = (s.p_O - center).transpose();
    columns.n.row(i) = s.n_O.transpose();
  }
  return columns;
}

// At most `count` of the points, evenly picked in their order.
inline PointColumns thinned(const PointColumns& points, Eigen::Index count) {
  if (points.size() <= count) return points;
  PointColumns kept{Eigen::MatrixX3d(count, 3), Eigen::MatrixX3d(count, 3)};
  for (Eigen::Index i = 0; i < count; ++i) {
    kept.p.row(i) = points.p.row(i * points.size() / count);
    kept.n.row(i) = points.n.row(i * points.size() / count);
  }
  return kept;
}

// The coordinates of the points in a frame with these axes (columns): a row for each point.
inline Eigen::MatrixX3d in_frame(const Matrix3& axes, const Eigen::MatrixX3d& points) {
  return points.lazyProduct(axes);
}

}  // namespace prehend
