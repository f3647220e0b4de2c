#include "sim/quality/wrench_hull.h"

#include <cmath>
#include <stdexcept>

#include "sim/quality/point_hull.h"
#include "sim/quality/start_simplex.h"

namespace prehend {

WrenchHull wrench_hull(const Wrenches& wrenches) {
  if (wrenches.cols() == 0) return {};
  const StartSimplex start = start_simplex(ColumnSupport(wrenches), false);
  if (start.flat) return {};
  PointHull points = point_hull(wrenches);
  if (points.status == PointHullStatus::failed) points = point_hull(wrenches, HullInput::joggled);
  if (points.status == PointHullStatus::failed) {
    throw std::runtime_error("qhull: " + points.message);
  }
  if (points.status == PointHullStatus::flat) return {};
  WrenchHull hull;
  hull.status = HullStatus::solid;
  hull.volume = points.volume;
  Eigen::Index nearest = 0;
  hull.min_offset = points.offsets.minCoeff(&nearest);
  hull.weakest = -hull.min_offset * points.normals.col(nearest);
  hull.doubt = kFlatness * start.scale + std::sqrt(6.0) * points.joggle;
  return hull;
}

}  // namespace prehend
