#include "sim/shape/overhang.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/shape/nearest_point.h"

namespace prehend {
namespace {

double squared_box_distance(const BoxNode& box, const Vector3& p) {
  return ((p - box.center).cwiseAbs() - box.half).cwiseMax(0.0).squaredNorm();
}

// Calls visit(point) at the centres of the n^2 equal triangles into which the triangle is divided.
template <typename Visit>
void spread_over(const std::array<Vector3, 3>& corners, int n, const Visit& visit) {
  const Vector3 u = (corners[1] - corners[0]) / n;
  const Vector3 v = (corners[2] - corners[0]) / n;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      visit(Vector3(corners[0] + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v));
      if (i + j + 1 < n) visit(Vector3(corners[0] + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v));
    }
  }
}

}  // namespace

OverhangGauge::OverhangGauge(TriangleMesh solid, const RunContext& context)
    : solid_(std::move(solid)),
      tree_(build_box_tree(solid_, context)),
      boundaries_(build_boundary_tree(solid_, tree_, context)) {
  if (solid_.empty()) throw InputError({.problem = "a mesh without triangles"});
}

bool OverhangGauge::contains(const Vector3& p) const {
  return winding_number(solid_, tree_, boundaries_, p) >= 0.5;
}

OverhangPoint OverhangGauge::nearest(const Vector3& p) const {
  OverhangPoint best;
  best.position = p;
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, int>> todo = {{squared_box_distance(tree_.front(), p), 0}};
  while (!todo.empty()) {
    const auto [at_least, node] = todo.back();
    todo.pop_back();
    if (at_least >= least) continue;
    const BoxNode& box = tree_[index(node)];
    if (box.is_leaf()) {
      const Triangle& t = solid_.triangles[index(box.triangle)];
      const Vector3 on =
          nearest_point_on({solid_.vertices[index(t[0])], solid_.vertices[index(t[1])],
                            solid_.vertices[index(t[2])]},
                           p);
      const double squared = (on - p).squaredNorm();
      if (squared < least) {
        least = squared;
        best.nearest = on;
      }
      continue;
    }
    std::pair<double, int> near{squared_box_distance(tree_[index(box.left)], p), box.left};
    std::pair<double, int> far{squared_box_distance(tree_[index(box.left + 1)], p), box.left + 1};
    if (far.first < near.first) std::swap(near, far);
    todo.push_back(far);
    todo.push_back(near);
  }
  best.distance = std::sqrt(least);
  return best;
}

std::vector<OverhangPoint> OverhangGauge::find(const TriangleMesh& hull, double tolerance,
                                               int samples) const {
  std::vector<OverhangPoint> found;
  const double area_each = surface_area(hull) / samples;
  for (std::size_t t = 0; t < hull.triangles.size(); ++t) {
    const double area = 0.5 * doubled_area_vector(hull, t).norm();
    const int n = static_cast<int>(std::ceil(std::sqrt(area / area_each)));
    const Triangle& corner = hull.triangles[t];
    const std::array<Vector3, 3> corners = {hull.vertices[index(corner[0])],
                                            hull.vertices[index(corner[1])],
                                            hull.vertices[index(corner[2])]};
    spread_over(corners, std::max(n, 1), [&](const Vector3& p) {
      const OverhangPoint at = nearest(p);
      if (at.distance > tolerance && !contains(p)) found.push_back(at);
    });
  }
  std::stable_sort(found.begin(), found.end(), [](const OverhangPoint& a, const OverhangPoint& b) {
    return a.distance > b.distance;
  });
  return found;
}

}  // namespace prehend
