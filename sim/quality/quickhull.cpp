#include "sim/quality/quickhull.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim/base/index.h"
#include "sim/quality/expanding_polytope.h"
#include "sim/quality/proved_volume.h"

// A polytope grows from a simplex of the points, point by point. Each column beyond it is kept with
// one of the facets that see it, in that facet's outside set. The one that is farthest above its
// facet is added next, and the outside sets of the facets that it replaces are shared out among the
// new facets. A column that none of these sees is inside.
namespace prehend {
namespace {

// Heights relative to the largest coordinate that are taken for rounding, tried one after the other
// until the hull is proved. Wrenches may be in one plane up to any error. Where that is about as
// large as what is taken for rounding, facets that should have the same plane do not, and fold.
constexpr std::array<double, 3> kRoundings = {1e-13, 3e-12, 1e-11};

// A list of columns, linked by HullGrowth::next_.
struct OutsideSet {
  int first = -1;
  int farthest = -1;
  double height = 0.0;  // of the farthest above the facet
};

template <int Dimension>
class HullGrowth {
 public:
  using Point = Eigen::Vector<double, Dimension>;
  using Points = Eigen::Matrix<double, Dimension, Eigen::Dynamic>;
  using Simplex = std::array<Point, static_cast<std::size_t>(Dimension) + 1>;

  // `scale`: the largest coordinate.
  HullGrowth(const Points& points, const Simplex& start, double scale, double rounding);

  void run();

  // Writes the facets' normals, offsets and corners.
  void write(PointHull& hull) const;

 private:
  void share_out(int first, std::span<const int> facets);
  void add_farthest(int facet);

  const Points& points_;
  PolytopeIn<Dimension> polytope_;
  std::vector<int> columns_;         // of the polytope's points
  std::vector<int> next_;            // column in the list that a column is in; -1: it is the last
  std::vector<OutsideSet> outside_;  // of each facet
  // Facets with columns outside, those with the highest on top. An entry whose facet was replaced
  // since is recognised by its height.
  std::vector<std::pair<double, int>> heap_;
};

template <int Dimension>
int column_of(const Eigen::Matrix<double, Dimension, Eigen::Dynamic>& points,
              const Eigen::Vector<double, Dimension>& point) {
  int column = 0;
  while (points.col(column) != point) {
    ++column;
    assert(column < points.cols());
  }
  return column;
}

template <int Dimension>
HullGrowth<Dimension>::HullGrowth(const Points& points, const Simplex& start, double scale,
                                  double rounding)
    : points_(points) {
  polytope_.start(start, scale, rounding, PolytopeIn<Dimension>::Planes::shared);
  polytope_.set_bound(-std::numeric_limits<double>::infinity());  // nearest() is not needed
  std::array<int, static_cast<std::size_t>(Dimension) + 1> facets = {};
  for (std::size_t corner = 0; corner < start.size(); ++corner) {
    columns_.push_back(column_of<Dimension>(points, start[corner]));
    facets[corner] = static_cast<int>(corner);
  }
  const int count = static_cast<int>(points.cols());
  for (int column = 0; column < count; ++column) {
    next_.push_back(column + 1 < count ? column + 1 : -1);
  }
  outside_.resize(facets.size());
  share_out(0, facets);
}

// Gives each column of the list to the first of the facets that sees it.
template <int Dimension>
void HullGrowth<Dimension>::share_out(int first, std::span<const int> facets) {
  for (int column = first; column >= 0;) {
    const int next = next_[index(column)];
    const Point point = points_.col(column);
    for (const int facet : facets) {
      const double height = polytope_.height(facet, point);
      if (height <= polytope_.rounding()) continue;
      OutsideSet& outside = outside_[index(facet)];
      next_[index(column)] = std::exchange(outside.first, column);
      if (height > outside.height) {
        outside.height = height;
        outside.farthest = column;
        heap_.emplace_back(height, facet);
        std::push_heap(heap_.begin(), heap_.end());
      }
      break;
    }
    column = next;
  }
}

template <int Dimension>
void HullGrowth<Dimension>::run() {
  while (!heap_.empty()) {
    const auto [height, facet] = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end());
    heap_.pop_back();
    if (height == outside_[index(facet)].height) add_farthest(facet);
  }
}

template <int Dimension>
void HullGrowth<Dimension>::add_farthest(int facet) {
  const int column = outside_[index(facet)].farthest;
  if (!polytope_.expand(facet, points_.col(column))) {
    // Rounding prevents it. The facet's columns are given up, and the proof tells what that costs.
    outside_[index(facet)] = {};
    return;
  }
  columns_.push_back(column);
  outside_.resize(index(polytope_.facet_end()));
  for (const int replaced : polytope_.replaced()) {
    share_out(std::exchange(outside_[index(replaced)], {}).first, polytope_.made());
  }
}

template <int Dimension>
void HullGrowth<Dimension>::write(PointHull& hull) const {
  std::vector<int> facets;
  for (int facet = 0; facet < polytope_.facet_end(); ++facet) {
    if (polytope_.exists(facet)) facets.push_back(facet);
  }
  const auto count = static_cast<Eigen::Index>(facets.size());
  hull.normals.resize(Dimension, count);
  hull.offsets.resize(count);
  hull.corners.resize(Dimension, count);
  for (Eigen::Index f = 0; f < count; ++f) {
    const int facet = facets[index(f)];
    hull.normals.col(f) = polytope_.plane(facet).normal;
    hull.offsets[f] = polytope_.plane(facet).offset;
    for (Eigen::Index i = 0; i < Dimension; ++i) {
      hull.corners(i, f) = columns_[index(polytope_.corners(facet)[index(i)])];
    }
  }
}

PointHull not_proved() {
  PointHull failed;
  failed.status = PointHullStatus::failed;
  failed.message = "quickhull: not proved";
  return failed;
}

// Four of the points that span space, each the one farthest from those before it.
std::optional<HullGrowth<3>::Simplex> spanning_points(const Eigen::Matrix3Xd& points) {
  constexpr double kFlat = 1e-9;  // of the distance between the first two
  HullGrowth<3>::Simplex simplex;
  Eigen::Index at = 0;
  points.row(0).minCoeff(&at);
  simplex[0] = points.col(at);
  const Eigen::Matrix3Xd ways = points.colwise() - simplex[0];
  const double length = std::sqrt(ways.colwise().squaredNorm().maxCoeff(&at));
  if (!(length > 0.0)) return std::nullopt;
  simplex[1] = points.col(at);
  const Eigen::Vector3d along = ways.col(at) / length;
  const Eigen::RowVectorXd parts = along.transpose() * ways;
  const double aside = std::sqrt((ways - along * parts).colwise().squaredNorm().maxCoeff(&at));
  if (!(aside > kFlat * length)) return std::nullopt;
  simplex[2] = points.col(at);
  const Eigen::Vector3d normal = along.cross(Eigen::Vector3d(ways.col(at))).normalized();
  const Eigen::RowVectorXd heights = normal.transpose() * ways;
  const double up = heights.cwiseAbs().maxCoeff(&at);
  if (!(up > kFlat * length)) return std::nullopt;
  simplex[3] = points.col(at);
  return simplex;
}

// The volume inside the facets, if they are closed and convex: no corner of one is above another,
// and their area vectors add up to zero.
std::optional<double> volume_inside(const Eigen::Matrix3Xd& points, double scale,
                                    const PointHull& hull) {
  constexpr double kError = 2e-11;  // of the scale
  std::vector<int> used(hull.corners.data(), hull.corners.data() + hull.corners.size());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  // One coordinate after the other, for lanes of the processor: this loop is the longest of all.
  const Eigen::ArrayX3d corners = points(Eigen::all, used).transpose();
  const Eigen::Vector3d apex = corners.colwise().mean();
  double volume = 0.0;
  double surface = 0.0;
  Eigen::Vector3d areas = Eigen::Vector3d::Zero();
  for (Eigen::Index f = 0; f < hull.offsets.size(); ++f) {
    const Eigen::Vector3d normal = hull.normals.col(f);
    const double above =
        (normal.x() * corners.col(0) + normal.y() * corners.col(1) + normal.z() * corners.col(2))
            .maxCoeff() -
        hull.offsets[f];
    if (!(above <= kError * scale)) return std::nullopt;
    const Eigen::Vector3d a = points.col(hull.corners(0, f));
    const Eigen::Vector3d b = points.col(hull.corners(1, f));
    const Eigen::Vector3d c = points.col(hull.corners(2, f));
    const double base = 0.5 * (b - a).cross(c - a).norm();
    surface += base;
    areas += base * normal;
    volume += (hull.offsets[f] - normal.dot(apex)) * base / 3.0;
  }
  const bool is_closed = areas.norm() <= 1e-9 * surface;
  return is_closed && std::isnormal(volume) ? std::optional(volume) : std::nullopt;
}

}  // namespace

PointHull quickhull(const Wrenches& wrenches, const StartSimplex& start) {
  PointHull hull;
  for (const double rounding : kRoundings) {
    HullGrowth<6> growth(wrenches, start.points, start.scale, rounding);
    growth.run();
    growth.write(hull);
    const std::optional<double> volume = proved_volume(wrenches, hull);
    if (!volume) continue;
    hull.status = PointHullStatus::solid;
    hull.volume = *volume;
    hull.reach = wrenches.colwise().norm().maxCoeff();
    return hull;
  }
  return not_proved();
}

PointHull quickhull(const Eigen::Matrix3Xd& points) {
  if (points.cols() < 4 || !points.allFinite()) return not_proved();
  const std::optional<HullGrowth<3>::Simplex> start = spanning_points(points);
  if (!start) return not_proved();
  const double scale = points.cwiseAbs().maxCoeff();
  PointHull hull;
  for (const double rounding : kRoundings) {
    HullGrowth<3> growth(points, *start, scale, rounding);
    growth.run();
    growth.write(hull);
    const std::optional<double> volume = volume_inside(points, scale, hull);
    if (!volume) continue;
    hull.status = PointHullStatus::solid;
    hull.volume = *volume;
    hull.reach = points.colwise().norm().maxCoeff();
    return hull;
  }
  return not_proved();
}

}  // namespace prehend
