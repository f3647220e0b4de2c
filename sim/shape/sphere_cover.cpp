#include "sim/shape/sphere_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "sim/base/index.h"
#include "sim/shape/nearest_point.h"
#include "sim/shape/nearest_triangle.h"
#include "sim/shape/proximity.h"

namespace prehend {
namespace {

// Points of the surface are so close together, as a part of the error. Each point of the surface is
// nearer than kMargin errors to one that is kept: to a corner of a small triangle (a triangle is
// nowhere farther from its corners than its longest edge over the root of 3), and from there to the
// one that was first in its cell.
constexpr double kSpacing = 0.0625;
constexpr double kMargin = kSpacing * (1.0 / std::numbers::sqrt3 + std::numbers::sqrt3);
static_assert(kMargin < 0.5);

// Points inside, in a grid: so many along the longest side of the body.
constexpr double kGrid = 16.0;
// Of the points of the surface every so many-th may be the centre of a sphere from the start.
constexpr std::size_t kCentersOnSurface = 400;

using Cell = std::array<long, 3>;

Cell cell_of(const Vector3& p, double size) {
  return {std::lround(std::floor(p.x() / size)), std::lround(std::floor(p.y() / size)),
          std::lround(std::floor(p.z() / size))};
}

// One point in each cell that the surface passes through.
std::vector<Vector3> points_of(const TriangleMesh& mesh, double spacing) {
  std::vector<Vector3> points;
  std::set<Cell> taken;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Corners c = corners_of(mesh, static_cast<int>(t));
    const Vector3 u = c[1] - c[0];
    const Vector3 v = c[2] - c[0];
    const double longest = std::max({u.norm(), v.norm(), (v - u).norm()});
    const int parts = std::max(1, static_cast<int>(std::ceil(longest / spacing)));
    for (int i = 0; i <= parts; ++i) {
      for (int k = 0; i + k <= parts; ++k) {
        const Vector3 p = c[0] + (double(i) / parts) * u + (double(k) / parts) * v;
        if (taken.insert(cell_of(p, spacing)).second) points.push_back(p);
      }
    }
  }
  return points;
}

double distance_from(const ProximityMesh& mesh, const Vector3& p, std::vector<int>& nearest) {
  constexpr double kSame = 1e-9;
  nearest_triangles(mesh, p, kSame, nearest);
  double least = std::numeric_limits<double>::infinity();
  for (const int t : nearest) {
    least = std::min(least, (nearest_point_on(corners_of(mesh.mesh(), t), p) - p).norm());
  }
  return least;
}

std::vector<CoverSphere> inner_spheres(const ProximityMesh& mesh, double error) {
  const Bounds box = bounds(mesh.mesh());
  const double step = std::max(box.size().maxCoeff() / kGrid, 0.5 * error);
  std::vector<CoverSphere> spheres;
  std::vector<int> nearest;
  const Vector3 first = box.lower + Vector3::Constant(0.5 * step);
  for (double x = first.x(); x < box.upper.x(); x += step) {
    for (double y = first.y(); y < box.upper.y(); y += step) {
      for (double z = first.z(); z < box.upper.z(); z += step) {
        const Vector3 p(x, y, z);
        if (is_inside(mesh, p)) spheres.push_back({p, distance_from(mesh, p, nearest) + error});
      }
    }
  }
  return spheres;
}

// Points of the surface that are not in a sphere yet, with all that lies around them up to the next
// ones.
class Uncovered {
 public:
  Uncovered(std::vector<Vector3> points, double margin)
      : points_(std::move(points)), margin_(margin) {}

  bool empty() const { return points_.empty(); }
  const Vector3& first() const { return points_.front(); }

  std::size_t count_in(const CoverSphere& sphere) const {
    return static_cast<std::size_t>(std::count_if(
        points_.begin(), points_.end(), [&](const Vector3& p) { return holds(sphere, p); }));
  }
  void take_out(const CoverSphere& sphere) {
    std::erase_if(points_, [&](const Vector3& p) { return holds(sphere, p); });
  }

 private:
  bool holds(const CoverSphere& sphere, const Vector3& p) const {
    const double reach = sphere.radius - margin_;
    return (p - sphere.center_M).squaredNorm() <= reach * reach;
  }

  std::vector<Vector3> points_;
  double margin_;
};

}  // namespace

std::vector<CoverSphere> sphere_cover(const ProximityMesh& mesh, double error) {
  std::vector<Vector3> points = points_of(mesh.mesh(), kSpacing * error);
  std::vector<CoverSphere> candidates = inner_spheres(mesh, error);
  const std::size_t every = points.size() / kCentersOnSurface + 1;
  for (std::size_t i = 0; i < points.size(); i += every) candidates.push_back({points[i], error});
  Uncovered left(std::move(points), kMargin * error);
  // How many points a sphere adds only becomes less. So one whose number of earlier is not above
  // the best so far is not asked again in a round.
  std::vector<std::pair<std::size_t, std::size_t>> gains;  // and the candidate
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    gains.emplace_back(left.count_in(candidates[c]), c);
  }
  std::vector<CoverSphere> chosen;
  while (!left.empty()) {
    std::sort(gains.begin(), gains.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    std::pair<std::size_t, std::size_t> best{0, 0};
    for (auto& [gain, c] : gains) {
      if (gain <= best.first) break;
      gain = left.count_in(candidates[c]);
      if (gain > best.first) best = {gain, c};
    }
    // A sphere about a point that none of them holds.
    const CoverSphere own{left.first(), error};
    const CoverSphere& next = best.first > 0 ? candidates[best.second] : own;
    chosen.push_back(next);
    left.take_out(chosen.back());
  }
  std::stable_sort(chosen.begin(), chosen.end(),
                   [](const CoverSphere& a, const CoverSphere& b) { return a.radius > b.radius; });
  return chosen;
}

}  // namespace prehend
