#include "sim/quality/set_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "sim/base/input_error.h"
#include "sim/base/require_settings.h"
#include "sim/quality/quickhull.h"
#include "sim/quality/start_simplex.h"

// Each round computes the hull of the points known so far, and asks for the set's support point
// along the normal of every facet. Points farther beyond their facet than the tolerance are added
// for the next round. The same support values bound the volume from above. Unlike the search for
// epsilon, which refines only the facets nearest to the origin, this refines all of them.
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

// Adds the point unless it is among those known; true if it was added.
bool add(Points& points, const Wrench& point) {
  if (std::find(points.begin(), points.end(), point) != points.end()) return false;
  points.push_back(point);
  return true;
}

// The corners of the start simplex and the extreme points along the six axes.
Points first_points(const SupportMap& set, const StartSimplex& start) {
  Points points(start.points.begin(), start.points.end());
  for (int axis = 0; axis < 6; ++axis) {
    add(points, set.support(Wrench::Unit(axis)));
    add(points, set.support(-Wrench::Unit(axis)));
  }
  return points;
}

// Where quickhull fails, qhull is asked. The start simplex has shown that the points span six
// dimensions, so a hull that qhull calls flat is a failure of precision just like one it cannot
// compute: both are tried again with joggled points.
PointHull hull_of(const Wrenches& points, const StartSimplex& start) {
  PointHull hull = quickhull(points, start);
  if (hull.status != PointHullStatus::solid) hull = point_hull(points);
  if (hull.status != PointHullStatus::solid) hull = point_hull(points, HullInput::joggled);
  if (hull.status != PointHullStatus::solid || !std::isfinite(hull.volume)) {
    hull.status = PointHullStatus::failed;
  }
  return hull;
}

// A point of the set beyond a facet of the hull.
struct Farther {
  double height = 0.0;  // above the facet
  Wrench point;
};

// What the set has beyond the facets of a hull inside it.
struct Beyond {
  std::vector<Farther> points;  // farther out than the tolerance, farthest first
  double volume_upper = 0.0;    // of the set
};

// The volume of the simplex with these edges from one of its corners: |det(edges)| / 6!.
double simplex_volume(const Eigen::Matrix<double, 6, 6>& edges) {
  constexpr double kFactorial = 720.0;  // of six dimensions
  return std::abs(edges.determinant()) / kFactorial;
}

// The volume of the pyramid over facet `f` with its apex at `centre`.
double pyramid_volume(const PointHull& hull, const Wrenches& points, const Wrench& centre,
                      Eigen::Index f) {
  Eigen::Matrix<double, 6, 6> edges;
  for (Eigen::Index i = 0; i < 6; ++i) edges.col(i) = points.col(hull.corners(i, f)) - centre;
  return simplex_volume(edges);
}

double volume_of(const StartSimplex& start) {
  Eigen::Matrix<double, 6, 6> edges;
  for (Eigen::Index i = 0; i < 6; ++i) {
    edges.col(i) = start.points[static_cast<std::size_t>(i) + 1] - start.points[0];
  }
  return simplex_volume(edges);
}

// The volume of the box along the axes around the set.
double box_volume(const SupportMap& set) {
  double volume = 1.0;
  for (int axis = 0; axis < 6; ++axis) {
    volume *= set.support(Wrench::Unit(axis))[axis] - set.support(-Wrench::Unit(axis))[axis];
  }
  return volume;
}

// Collects the points of the set beyond the facets, and bounds the set's volume. The rays from the
// centre through a facet fill a cone, and the cones of all facets fill space. In each of them the
// set ends at the latest at its support plane with the facet's normal. The pyramid from the centre
// to the facet, enlarged until its base is in that plane, contains this part of the set; enlarging
// by a factor multiplies a volume in six dimensions by its sixth power. A facet that rounding has
// put on the wrong side of the centre proves nothing: the bound is then infinite.
Beyond look_beyond(const SupportMap& set, const PointHull& hull, const Wrenches& points,
                   double tolerance) {
  Beyond beyond;
  const Wrench centre = points.rowwise().mean();
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    const Wrench normal = hull.normals.col(f);
    const Wrench point = set.support(normal);
    const double inside = hull.offsets[f] - normal.dot(centre);
    const double outside = normal.dot(point) - normal.dot(centre);
    if (!(inside > 0.0)) {
      beyond.volume_upper = std::numeric_limits<double>::infinity();
      continue;
    }
    const double enlarge = std::max(1.0, outside / inside);
    beyond.volume_upper += std::pow(enlarge, 6.0) * pyramid_volume(hull, points, centre, f);
    if (outside - inside > tolerance) beyond.points.push_back({outside - inside, point});
  }
  std::stable_sort(beyond.points.begin(), beyond.points.end(),
                   [](const Farther& a, const Farther& b) { return a.height > b.height; });
  return beyond;
}

// How many points the next round may have: twice as many at most, and not so many that the hull is
// likely to exceed the limit of facets. Their number grows with the third power of the number of
// points where it grows fastest (the upper bound theorem in six dimensions, McMullen 1970).
std::size_t most_points(std::size_t points, Eigen::Index facets, const SetHullOptions& options) {
  const double room = std::cbrt(std::max(options.max_facets, 0) / static_cast<double>(facets));
  const auto allowed = static_cast<std::size_t>(room * static_cast<double>(points));
  return std::min({2 * points, allowed, static_cast<std::size_t>(std::max(options.max_points, 0))});
}

}  // namespace

SetHull set_hull(const SupportMap& set, const SetHullOptions& options) {
  require_settings(options);
  SetHull result;
  const StartSimplex start = start_simplex(set, false);
  if (start.flat) {
    result.complete = true;
    return result;
  }
  const double box = box_volume(set);
  result.volume_lower = std::min(volume_of(start), box);
  result.volume_upper = box;
  result.hull.status = PointHullStatus::failed;
  Points points = first_points(set, start);
  while (true) {
    const Wrenches columns = columns_of(points);
    PointHull hull = hull_of(columns, start);
    if (hull.status != PointHullStatus::solid) return result;
    result.hull = std::move(hull);
    const Beyond beyond =
        look_beyond(set, result.hull, columns, options.relative_tolerance * start.scale);
    result.volume_lower = result.hull.volume;
    result.volume_upper = std::max(std::min(beyond.volume_upper, box), result.volume_lower);
    // Farthest points first: many facets ask for almost the same point, and only the next hull
    // tells which of them are still needed.
    const std::size_t most = most_points(points.size(), result.hull.offsets.size(), options);
    for (const Farther& farther : beyond.points) {
      if (points.size() < most) add(points, farther.point);
    }
    result.complete = beyond.points.empty();
    // Nothing was added: complete, at a limit, or only known points are beyond facets (rounding).
    if (points.size() == static_cast<std::size_t>(columns.cols())) return result;
  }
}

}  // namespace prehend
