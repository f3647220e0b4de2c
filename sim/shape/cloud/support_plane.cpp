#include "sim/shape/cloud/support_plane.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "sim/base/index.h"
#include "sim/base/random.h"
#include "sim/shape/cloud/seen_surface.h"

namespace prehend {
namespace {

constexpr std::size_t kReadings = 20000;  // that the plane is found in
constexpr std::size_t kLookedAt = 2000;   // of each view, for normals
constexpr double kAsLevel = 0.9;          // cosine of the angle between normals
constexpr int kHypotheses = 700;
constexpr std::size_t kScored = 2500;  // readings on which a hypothesis is judged
constexpr double kLeastShare = 0.12;   // of the readings, on a support
constexpr double kLevel = 0.52;        // a support tilted less is preferred [rad]
constexpr double kPlaneOnly = 0.995;   // of the readings
constexpr double kLeastTable = 0.3;    // a plane alone that is smaller may be a thing [m]
constexpr double kHighestThing = 1.0;  // above a support [m]

struct Plane {
  Vector3 normal = Vector3::UnitZ();
  double offset = 0.0;  // normal . p on it

  double height(const Vector3& p) const { return normal.dot(p) - offset; }
};

std::size_t count_on(const Plane& plane, const std::vector<Vector3>& points, double tolerance,
                     std::size_t stride) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    count += std::abs(plane.height(points[i])) <= tolerance ? 1U : 0U;
  }
  return count;
}

void face(Plane& plane, const Vector3& camera) {
  if (plane.height(camera) >= 0.0) return;
  plane.normal = -plane.normal;
  plane.offset = -plane.offset;
}

Plane best_hypothesis(const std::vector<Vector3>& points, const Vector3& camera, double tolerance,
                      Random& random) {
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kScored);
  Plane best;
  double best_score = -1.0;
  for (int k = 0; k < kHypotheses; ++k) {
    const Vector3& a = points[random.index(points.size())];
    const Vector3& b = points[random.index(points.size())];
    const Vector3& c = points[random.index(points.size())];
    const Vector3 normal = (b - a).cross(c - a);
    // Three readings that are close together say little of a large plane.
    if (normal.norm() < 4e-4) continue;
    Plane plane{normal.normalized(), 0.0};
    plane.offset = plane.normal.dot(a);
    face(plane, camera);
    const double factor = plane.normal.z() > std::cos(kLevel) ? 1.0 : 0.5;
    const double score = factor * static_cast<double>(count_on(plane, points, tolerance, stride));
    if (score > best_score) {
      best_score = score;
      best = plane;
    }
  }
  return best;
}

// Least squares of the readings on the plane, as often as it takes to settle.
Plane refined(Plane plane, const std::vector<Vector3>& points, const Vector3& camera,
              double tolerance) {
  for (int round = 0; round < 4; ++round) {
    Vector3 sum = Vector3::Zero();
    double count = 0.0;
    for (const Vector3& p : points) {
      if (std::abs(plane.height(p)) > tolerance) continue;
      sum += p;
      count += 1.0;
    }
    if (count < 3.0) return plane;
    const Vector3 middle = sum / count;
    Matrix3 spread = Matrix3::Zero();
    for (const Vector3& p : points) {
      if (std::abs(plane.height(p)) > tolerance) continue;
      spread += (p - middle) * (p - middle).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Matrix3> axes(spread);
    plane.normal = axes.eigenvectors().col(0).normalized();
    plane.offset = plane.normal.dot(middle);
    face(plane, camera);
  }
  return plane;
}

double cross2(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// The convex hull of points, counter-clockwise (Andrew's monotone chain, 1979).
std::vector<Eigen::Vector2d> flat_hull(std::vector<Eigen::Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  std::vector<Eigen::Vector2d> hull;
  const auto add = [&](const Eigen::Vector2d& p, std::size_t least) {
    while (hull.size() >= least + 2 &&
           cross2(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const auto& p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  if (hull.size() > 1) hull.pop_back();
  return hull;
}

SupportPlane outlined(const Plane& plane, const std::vector<Vector3>& points, double tolerance) {
  SupportPlane support;
  support.normal_W = plane.normal;
  support.tilt = std::acos(std::clamp(plane.normal.z(), -1.0, 1.0));
  const Vector3 x = any_orthogonal(plane.normal);
  const Vector3 y = plane.normal.cross(x);
  std::vector<Eigen::Vector2d> flat;
  for (const Vector3& p : points) {
    if (std::abs(plane.height(p)) <= tolerance) flat.emplace_back(x.dot(p), y.dot(p));
  }
  for (const Eigen::Vector2d& p : flat_hull(std::move(flat))) {
    support.outline_W.emplace_back(p.x() * x + p.y() * y + plane.offset * plane.normal);
  }
  return support;
}

// The mean of the readings that stand on the plane; none where there are too few.
std::optional<Vector3> middle_of_things(const SupportPlane& support, const Plane& plane,
                                        const std::vector<Vector3>& points, double tolerance) {
  Vector3 sum = Vector3::Zero();
  std::size_t count = 0;
  for (const Vector3& p : points) {
    const double height = plane.height(p);
    if (height < 2.0 * tolerance || height > kHighestThing || !above_outline(support, p, 0.0)) {
      continue;
    }
    sum += p;
    ++count;
  }
  if (count < std::max<std::size_t>(8, points.size() / 2000)) return {};
  return sum / static_cast<double>(count);
}

// Readings of all views, frame W, thinned to what finding a plane takes.
std::vector<Vector3> thinned_readings(const std::vector<DepthView>& views) {
  std::size_t total = 0;
  for (const DepthView& view : views) total += view.depth.size();
  const std::size_t stride = std::max<std::size_t>(1, total / kReadings);
  std::vector<Vector3> readings;
  for (const DepthView& view : views) {
    const auto width = index(view.camera.width);
    for (std::size_t i = stride / 2; i < view.depth.size(); i += stride) {
      if (view.depth[i] <= 0.0F) continue;
      const Eigen::Vector3f p_C =
          reading_at(view, static_cast<int>(i % width), static_cast<int>(i / width));
      readings.push_back(view.camera.X_WC * p_C.cast<double>());
    }
  }
  return readings;
}

double extent_of(const SupportPlane& support) {
  double across = 0.0;
  for (const Vector3& corner : support.outline_W) {
    across = std::max(across, (corner - support.outline_W.front()).norm());
  }
  return across;
}

// Whether the surface around most readings on a plane has its normal.
bool level_around(const Plane& plane, const std::vector<DepthView>& views, double noise,
                  double tolerance) {
  int level = 0;
  int looked_at = 0;
  for (const DepthView& view : views) {
    const PlaneFitter fitter(view, noise);
    const Vector3 normal_C = view.camera.X_WC.linear().transpose() * plane.normal;
    const auto width = index(view.camera.width);
    const std::size_t stride = std::max<std::size_t>(1, view.depth.size() / kLookedAt);
    for (std::size_t i = stride / 2; i < view.depth.size(); i += stride) {
      if (view.depth[i] <= 0.0F) continue;
      const auto u = static_cast<int>(i % width);
      const auto v = static_cast<int>(i / width);
      const Vector3 p_W = view.camera.X_WC * reading_at(view, u, v).cast<double>();
      if (std::abs(plane.height(p_W)) > tolerance) continue;
      const LocalPlane around = fitter.at(u, v);
      ++looked_at;
      level += around.exists() && around.normal().cast<double>().dot(normal_C) > kAsLevel ? 1 : 0;
    }
  }
  return 2 * level > looked_at;
}

}  // namespace

bool above_outline(const SupportPlane& plane, const Vector3& p_W, double margin) {
  const std::size_t count = plane.outline_W.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Vector3& a = plane.outline_W[i];
    const Vector3 along = plane.outline_W[(i + 1) % count] - a;
    const Vector3 inward = plane.normal_W.cross(along);
    if (inward.dot(p_W - a) < -margin * inward.norm()) return false;
  }
  return count >= 3;
}

PlaneSearch find_support(const std::vector<DepthView>& views, double noise, std::uint64_t seed) {
  PlaneSearch search;
  Random random(derived_seed(seed, 1));
  const double tolerance = std::max(4e-3, 3.0 * noise);
  const Vector3 camera = views.front().camera.X_WC.translation();
  const std::vector<Vector3> readings = thinned_readings(views);
  std::vector<Vector3> left = readings;
  const auto least = static_cast<std::size_t>(kLeastShare * static_cast<double>(readings.size()));
  for (int round = 0; round < 3 && left.size() >= std::max<std::size_t>(least, 16); ++round) {
    Plane plane = best_hypothesis(left, camera, tolerance, random);
    plane = refined(plane, left, camera, 2.0 * tolerance);
    plane = refined(plane, left, camera, tolerance);
    const std::size_t on = count_on(plane, left, tolerance, 1);
    if (on < std::max<std::size_t>(least, 3)) break;
    SupportPlane support = outlined(plane, left, tolerance);
    const std::optional<Vector3> things = middle_of_things(support, plane, readings, tolerance);
    if (things && level_around(plane, views, noise, tolerance)) {
      const Vector3 foot = *things - plane.height(*things) * plane.normal;
      support.height = foot.z();
      search.found = FoundPlane{support, foot};
      return search;
    }
    if (static_cast<double>(on) > kPlaneOnly * static_cast<double>(readings.size()) &&
        extent_of(support) > kLeastTable) {
      search.plane_only = true;
      return search;
    }
    std::erase_if(left, [&](const Vector3& p) { return std::abs(plane.height(p)) <= tolerance; });
  }
  return search;
}

}  // namespace prehend
