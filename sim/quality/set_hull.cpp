#include "sim/quality/set_hull.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/LU>

#include "sim/base/input_error.h"
#include "sim/quality/start_simplex.h"

namespace prehend {
namespace {

using Points = std::vector<Wrench>;

Wrenches columns_of(const Points& points) {
  Wrenches columns(6, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index j = 0; j < columns.cols(); ++j) {
    columns.col(j) = points[static_cast<std::size_t>(j)];
  }
  return columns;
}

// Adds a point that is not among those known.
bool add(Points& points, const Wrench& point) {
  if (std::find(points.begin(), points.end(), point) != points.end()) return false;
  points.push_back(point);
  return true;
}

Points first_points(const SupportMap& set, const StartSimplex& start) {
  Points points(start.points.begin(), start.points.end());
  for (int axis = 0; axis < 6; ++axis) {
    add(points, set.support(Wrench::Unit(axis)));
    add(points, set.support(-Wrench::Unit(axis)));
  }
  return points;
}

PointHull hull_of(const Wrenches& points) {
  PointHull hull = point_hull(points);
  if (hull.status != PointHullStatus::solid) hull = point_hull(points, HullInput::joggled);
  if (hull.status == PointHullStatus::failed) throw std::runtime_error("qhull: " + hull.message);
  return hull;
}

struct Farther {
  double height = 0.0;  // above the facet
  Wrench point;
};

// What the set has beyond the facets of a hull inside it.
struct Beyond {
  std::vector<Farther> points;  // farther out than the tolerance, farthest first
  double volume_upper = 0.0;    // of the set
};

// Of the pyramid over facet `f` with its apex at `centre`.
double pyramid_volume(const PointHull& hull, const Wrenches& points, const Wrench& centre,
                      Eigen::Index f) {
  constexpr double kFactorial = 720.0;  // of six dimensions
  Eigen::Matrix<double, 6, 6> edges;
  for (Eigen::Index i = 0; i < 6; ++i) edges.col(i) = points.col(hull.corners(i, f)) - centre;
  return std::abs(edges.determinant()) / kFactorial;
}

// Seen from the centre, the set behind a facet ends at the support plane of the facet's normal: the
// pyramid over the facet, enlarged up to that plane, contains it.
Beyond look_beyond(const SupportMap& set, const PointHull& hull, const Wrenches& points,
                   double tolerance) {
  Beyond beyond;
  const Wrench centre = points.rowwise().mean();
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    const Wrench normal = hull.normals.col(f);
    const Wrench point = set.support(normal);
    const double inside = hull.offsets[f] - normal.dot(centre);
    const double outside = normal.dot(point) - normal.dot(centre);
    const double enlarge = std::max(1.0, outside / inside);
    beyond.volume_upper += std::pow(enlarge, 6.0) * pyramid_volume(hull, points, centre, f);
    if (outside - inside > tolerance) beyond.points.push_back({outside - inside, point});
  }
  std::stable_sort(beyond.points.begin(), beyond.points.end(),
                   [](const Farther& a, const Farther& b) { return a.height > b.height; });
  return beyond;
}

}  // namespace

SetHull set_hull(const SupportMap& set, const SetHullOptions& options) {
  if (!(options.relative_tolerance > 0.0)) {
    throw InputError({.field = "relative_tolerance",
                      .problem = "must be positive",
                      .value = std::to_string(options.relative_tolerance)});
  }
  SetHull result;
  const StartSimplex start = start_simplex(set, false);
  if (start.flat) {
    result.complete = true;
    return result;
  }
  Points points = first_points(set, start);
  while (true) {
    const Wrenches columns = columns_of(points);
    result.hull = hull_of(columns);
    const Beyond beyond =
        look_beyond(set, result.hull, columns, options.relative_tolerance * start.scale);
    result.volume_lower = result.hull.volume;
    result.volume_upper = std::max(beyond.volume_upper, result.volume_lower);
    // At most doubled in a round: many facets ask for almost the same point.
    const std::size_t most =
        std::min(2 * points.size(), static_cast<std::size_t>(std::max(options.max_points, 0)));
    for (const Farther& farther : beyond.points) {
      if (points.size() < most) add(points, farther.point);
    }
    result.complete = beyond.points.empty();
    if (points.size() == static_cast<std::size_t>(columns.cols())) return result;
  }
}

}  // namespace prehend
