#include "primitives/smoothed_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/base/parallel/parallel.h"

namespace prehend {
namespace {

// The points by the cells of a grid, to visit those near a place.
class PointGrid {
 public:
  PointGrid(const std::vector<SurfacePoint>& points, double radius)
      : points_(points), radius_(radius), cell_(radius) {
    Bounds around;
    for (const SurfacePoint& s : points) {
      around.lower = around.lower.cwiseMin(s.p_O);
      around.upper = around.upper.cwiseMax(s.p_O);
    }
    // Points far apart beside the radius must not make the grid larger than memory.
    constexpr double kMostCells = 200.0;
    cell_ = std::max(cell_, around.size().maxCoeff() / kMostCells);
    origin_ = around.lower;
    cells_ = (around.size() / cell_).array().floor().cast<int>() + 1;
    first_.assign(static_cast<std::size_t>(cells_.prod()) + 1, 0);
    for (const SurfacePoint& s : points) ++first_[index(cell_of(s.p_O)) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    members_.resize(points.size());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      members_[next[index(cell_of(points[i].p_O))]++] = i;
    }
  }

  // Calls visit(index, weight) for the points within the radius; the weight falls from 1 to 0.
  template <typename Visit>
  void for_each_near(const Vector3& p, const Visit& visit) const {
    const Eigen::Vector3i at = cell_of(p);
    const Eigen::Vector3i low = (at.array() - 1).max(0);
    const Eigen::Vector3i high = (at.array() + 1).min(cells_.array() - 1);
    for (int z = low.z(); z <= high.z(); ++z) {
      for (int y = low.y(); y <= high.y(); ++y) {
        // The cells of a row are one after the other.
        const std::size_t end = first_[index({high.x(), y, z}) + 1];
        for (std::size_t k = first_[index({low.x(), y, z})]; k < end; ++k) {
          const std::size_t i = members_[k];
          const double left = 1.0 - (points_[i].p_O - p).squaredNorm() / (radius_ * radius_);
          if (left > 0.0) visit(i, left * left);
        }
      }
    }
  }

 private:
  Eigen::Vector3i cell_of(const Vector3& p) const {
    return ((p - origin_) / cell_).array().floor().cast<int>().max(0).min(cells_.array() - 1);
  }
  std::size_t index(const Eigen::Vector3i& c) const {
    return static_cast<std::size_t>((c.z() * cells_.y() + c.y()) * cells_.x() + c.x());
  }

  const std::vector<SurfacePoint>& points_;
  double radius_;
  double cell_;
  Vector3 origin_ = Vector3::Zero();
  Eigen::Vector3i cells_ = Eigen::Vector3i::Zero();
  std::vector<std::size_t> first_;    // of each cell: its place in members_
  std::vector<std::size_t> members_;  // cell by cell
};

class Smoother {
 public:
  Smoother(const std::vector<SurfacePoint>& points, double radius, int threads)
      : points_(points), grid_(points, radius), threads_(threads) {
    for (const SurfacePoint& s : points) normals_.push_back(s.n_O);
  }

  // Replaces each normal by the mean of those near it, of all that are within a right angle and
  // more of it (`alike`: least cosine). Means keep their length: where normals disagree, they count
  // less in the next mean.
  void average_normals(const PointGrid& grid, double alike) {
    // A shorter mean is of two sides of a wall: it says nothing of either.
    constexpr double kShortest = 0.05;
    std::vector<Vector3> means(points_.size());
    for_each_point([&](std::size_t i) {
      const double own = normals_[i].norm();
      Vector3 sum = Vector3::Zero();
      double weights = 0.0;
      grid.for_each_near(points_[i].p_O, [&](std::size_t j, double weight) {
        if (normals_[j].dot(normals_[i]) < alike * own * normals_[j].norm()) return;
        sum += weight * normals_[j];
        weights += weight;
      });
      means[i] = sum.norm() > kShortest * own * weights ? Vector3(sum / weights) : normals_[i];
    });
    normals_ = std::move(means);
  }
  void average_normals(double alike) { average_normals(grid_, alike); }

  // The area of the smooth surface for which each point stands, in that of the rough one.
  std::vector<double> smooth_areas() const {
    std::vector<double> areas(points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double length = normals_[i].norm();
      areas[i] = length > 0.0 ? std::max(points_[i].n_O.dot(normals_[i]) / length, 0.0) : 0.0;
    }
    return areas;
  }

  // These points on the smooth surface.
  std::vector<SurfacePoint> moved(const std::vector<std::size_t>& kept,
                                  const std::vector<double>& areas) const {
    constexpr double kSameSide = 0.5;
    std::vector<SurfacePoint> smooth = turned(kept);
    for_each_in_parallel(kept.size(), threads_, [&](std::size_t k) {
      SurfacePoint& s = smooth[k];
      Vector3 sum = Vector3::Zero();
      double weights = 0.0;
      grid_.for_each_near(s.p_O, [&](std::size_t j, double near) {
        if (normals_[j].dot(s.n_O) < kSameSide * normals_[j].norm()) return;
        sum += areas[j] * near * points_[j].p_O;
        weights += areas[j] * near;
      });
      if (weights > 0.0) s.p_O -= s.n_O.dot(s.p_O - sum / weights) * s.n_O;
    });
    return smooth;
  }

  // These points where they are, with their new normals.
  std::vector<SurfacePoint> turned(const std::vector<std::size_t>& kept) const {
    std::vector<SurfacePoint> points;
    points.reserve(kept.size());
    for (const std::size_t i : kept) {
      points.push_back({points_[i].p_O, normals_[i].normalized(), points_[i].triangle});
    }
    return points;
  }

 private:
  template <typename Work>
  void for_each_point(const Work& work) const {
    constexpr std::size_t kAtOnce = 256;
    for_each_in_parallel((points_.size() + kAtOnce - 1) / kAtOnce, threads_, [&](std::size_t part) {
      const std::size_t end = std::min((part + 1) * kAtOnce, points_.size());
      for (std::size_t i = part * kAtOnce; i < end; ++i) work(i);
    });
  }

  const std::vector<SurfacePoint>& points_;
  PointGrid grid_;
  int threads_;
  std::vector<Vector3> normals_;
};

// Every point whose area completes another step of the whole: `count` of them, spread as the points
// are.
std::vector<std::size_t> evenly_picked(const std::vector<double>& areas, std::size_t count) {
  double sum = 0.0;
  for (const double area : areas) sum += area;
  const double step = sum / static_cast<double>(count);
  std::vector<std::size_t> picked;
  double total = 0.0;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const double before = std::floor(total / step);
    total += areas[i];
    if (areas[i] > 0.0 && std::floor(total / step) > before) picked.push_back(i);
  }
  return picked;
}

}  // namespace

SmoothedPoints smoothed_points(const std::vector<SurfacePoint>& points, double radius,
                               std::size_t count, int threads) {
  // Within this part of the radius even the two sides of a wall are averaged: a crumpled surface
  // has no sides that its single triangles tell.
  constexpr double kBlind = 0.35;
  constexpr double kAll = -2.0;  // below any cosine
  Smoother smoother(points, radius, threads);
  smoother.average_normals(PointGrid(points, kBlind * radius), kAll);
  smoother.average_normals(0.2);
  smoother.average_normals(0.5);
  const std::vector<double> areas = smoother.smooth_areas();
  const std::vector<std::size_t> kept = evenly_picked(areas, count);
  return {smoother.moved(kept, areas), smoother.turned(kept)};
}

}  // namespace prehend
