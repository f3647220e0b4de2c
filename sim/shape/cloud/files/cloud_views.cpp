#include "sim/shape/cloud/files/cloud_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "sim/base/formatted.h"
#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/range.h"
#include "sim/shape/cloud/files/depth_checks.h"
#include "sim/shape/triangle_mesh.h"

namespace prehend {
namespace {

// Readings in metres; normals are unit, or zero where they are not known.
struct Readings {
  std::vector<Vector3> points;
  std::vector<Vector3> normals;  // as many, or none
};

Readings readings_of(const PointCloud& cloud, double metres_per_unit,
                     std::vector<std::string>& notes) {
  Readings readings;
  std::size_t scaled = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Vector3 p = metres_per_unit * cloud.points[i].cast<double>();
    if (!p.allFinite()) continue;
    require(p.cwiseAbs().maxCoeff() <= kFarthest,
            {.problem = formatted("point %zu is farther out than 1e6 m", i)});
    readings.points.push_back(p);
    if (cloud.normals.empty()) continue;
    const Vector3 normal = cloud.normals[i].cast<double>();
    const double length = normal.allFinite() ? normal.norm() : 0.0;
    constexpr double kShortest = 1e-12;
    constexpr double kUnit = 1e-2;
    if (length > kShortest && std::abs(length - 1.0) > kUnit) ++scaled;
    readings.normals.push_back(length > kShortest ? Vector3(normal / length) : Vector3::Zero());
  }
  const std::size_t missing = cloud.points.size() - readings.points.size();
  require(cloud.points.empty() || !readings.points.empty(),
          {.problem = formatted("no reading: none of the %zu points is finite", missing)});
  if (missing > 0) notes.push_back(formatted("%zu points are not finite: no readings", missing));
  if (scaled > 0) notes.push_back(formatted("%zu normals are not unit: normalised", scaled));
  return readings;
}

// Slopes x / z and y / z of what a camera sees, and how far along z it is.
struct Ray {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
};

// How many rays there are about one of them in a square of slope 1: in squares of this side, the
// median over all rays.
double density(const std::vector<Ray>& rays, double side) {
  std::unordered_map<std::uint64_t, int> counts;
  const auto cell = [&](const Ray& ray) {
    const auto column = static_cast<std::int64_t>(std::floor(ray.x / side));
    const auto row = static_cast<std::int64_t>(std::floor(ray.y / side));
    return static_cast<std::uint64_t>(column) << 32U ^ static_cast<std::uint32_t>(row);
  };
  for (const Ray& ray : rays) ++counts[cell(ray)];
  std::vector<int> of_each;
  of_each.reserve(rays.size());
  for (const Ray& ray : rays) of_each.push_back(counts[cell(ray)]);
  const auto middle = of_each.begin() + static_cast<std::ptrdiff_t>(of_each.size() / 2);
  std::nth_element(of_each.begin(), middle, of_each.end());
  return *middle / (side * side);
}

struct SlopeBounds {
  double left = 0.0;
  double top = 0.0;
  double width = 0.0;
  double height = 0.0;
};

SlopeBounds bounds_of(const std::vector<Ray>& rays) {
  SlopeBounds bounds{rays.front().x, rays.front().y, 0.0, 0.0};
  double right = bounds.left;
  double bottom = bounds.top;
  for (const Ray& ray : rays) {
    bounds.left = std::min(bounds.left, ray.x);
    right = std::max(right, ray.x);
    bounds.top = std::min(bounds.top, ray.y);
    bottom = std::max(bottom, ray.y);
  }
  bounds.width = right - bounds.left;
  bounds.height = bottom - bounds.top;
  return bounds;
}

// The focal length [pixels] at which there is about one pixel for each one and a half rays, within
// what an image may have.
double focal_length(const std::vector<Ray>& rays, const SlopeBounds& bounds) {
  constexpr double kRaysPerPixel = 1.5;
  constexpr double kRaysPerSquare = 16.0;
  constexpr double kLongestSide = 2000.0;  // pixels
  constexpr double kShortest = 10.0;
  const double extent = std::max({bounds.width, bounds.height, 1e-6});
  const double area = std::max(bounds.width * bounds.height, extent * extent * 1e-3);
  double per_area = static_cast<double>(rays.size()) / area;
  // Twice: the squares of the first time are too large where the rays are in few places.
  for (int i = 0; i < 2; ++i) {
    per_area = density(rays, std::max(std::sqrt(kRaysPerSquare / per_area), extent * 1e-5));
  }
  return std::clamp(std::sqrt(per_area / kRaysPerPixel), kShortest, kLongestSide / extent);
}

// The nearest of so many pixels: of the outermost rays rounding may find one beyond.
int pixel(double at, int count) {
  return std::clamp(static_cast<int>(std::lround(at)), 0, count - 1);
}

// The image of these rays: of those in one pixel the nearest. Not empty.
DepthView image_of(const std::vector<Ray>& rays, const Pose& X_WC) {
  const SlopeBounds bounds = bounds_of(rays);
  const double f = focal_length(rays, bounds);
  DepthView view;
  DepthCamera& camera = view.camera;
  camera.X_WC = X_WC;
  camera.fx = f;
  camera.fy = f;
  camera.cx = -f * bounds.left;
  camera.cy = -f * bounds.top;
  camera.width = static_cast<int>(std::lround(f * bounds.width)) + 1;
  camera.height = static_cast<int>(std::lround(f * bounds.height)) + 1;
  view.depth.assign(index(camera.width) * index(camera.height), 0.0F);
  for (const Ray& ray : rays) {
    const int u = pixel(f * ray.x + camera.cx, camera.width);
    const int v = pixel(f * ray.y + camera.cy, camera.height);
    float& depth = view.depth[index(v) * index(camera.width) + index(u)];
    if (depth == 0.0F || ray.z < depth) depth = static_cast<float>(ray.z);
  }
  return view;
}

// The camera at `p` that looks along `axis` (unit), with z of the frame up in its image where that
// is a direction.
Pose looking_along(const Vector3& axis, const Vector3& p) {
  constexpr double kSteep = 0.99;
  const Vector3 up = std::abs(axis.z()) < kSteep ? Vector3::UnitZ() : Vector3::UnitY();
  Matrix3 axes;
  axes.col(2) = axis;
  axes.col(1) = (axis.dot(up) * axis - up).normalized();
  axes.col(0) = axes.col(1).cross(axes.col(2));
  return pose_from(axes, p);
}

// What of the points lies in a cone around the axis of the camera.
std::vector<Ray> rays_from(const Pose& X_FC, const std::vector<Vector3>& points,
                           const std::vector<char>* wanted = nullptr) {
  constexpr double kSteepest = 4.0;
  const Pose X_CF = X_FC.inverse();
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (wanted != nullptr && (*wanted)[i] == 0) continue;
    const Vector3 p = X_CF * points[i];
    if (p.z() <= 0.0 || std::hypot(p.x(), p.y()) > kSteepest * p.z()) continue;
    rays.push_back({p.x() / p.z(), p.y() / p.z(), p.z()});
  }
  return rays;
}

// One image, or those of the six sides of a cube, of what is all around.
std::vector<DepthView> views_from(const Vector3& viewpoint, const Readings& readings,
                                  const Pose& X_WF) {
  constexpr double kNarrow = 0.5;  // cosine of the half angle of one image
  Vector3 sum = Vector3::Zero();
  for (const Vector3& p : readings.points) sum += (p - viewpoint).normalized();
  const Vector3 axis = sum.norm() > 0.0 ? Vector3(sum.normalized()) : Vector3::UnitZ();
  const bool is_narrow = std::all_of(
      readings.points.begin(), readings.points.end(),
      [&](const Vector3& p) { return (p - viewpoint).normalized().dot(axis) > kNarrow; });
  if (is_narrow) {
    const Pose X_FC = looking_along(axis, viewpoint);
    return {image_of(rays_from(X_FC, readings.points), X_WF * X_FC)};
  }
  std::vector<DepthView> views;
  for (int side = 0; side < 6; ++side) {
    const Vector3 along = (side < 3 ? 1.0 : -1.0) * Vector3::Unit(side % 3);
    std::vector<char> wanted;
    for (const Vector3& p : readings.points) {
      int most = 0;
      const Vector3 from = p - viewpoint;
      from.cwiseAbs().maxCoeff(&most);
      wanted.push_back(most == side % 3 && from.dot(along) > 0.0 ? 1 : 0);
    }
    const Pose X_FC = looking_along(along, viewpoint);
    const std::vector<Ray> rays = rays_from(X_FC, readings.points, &wanted);
    if (!rays.empty()) views.push_back(image_of(rays, X_WF * X_FC));
  }
  return views;
}

// The six axes and the eight diagonals: none is farther than 28 degrees from a direction.
std::vector<Vector3> directions_around() {
  std::vector<Vector3> directions;
  for (int side = 0; side < 6; ++side) {
    directions.emplace_back((side < 3 ? 1.0 : -1.0) * Vector3::Unit(side % 3));
  }
  for (int corner = 0; corner < 8; ++corner) {
    const auto sign = [&](int bit) { return (corner >> bit & 1) != 0 ? 1.0 : -1.0; };
    directions.emplace_back(Vector3(sign(0), sign(1), sign(2)).normalized());
  }
  return directions;
}

// Cameras around the points, three times their radius away from their middle.
std::vector<DepthView> views_around(const Readings& readings, const Pose& X_WF) {
  constexpr double kFaces = 0.3;  // cosine between a normal and the way to a camera that sees it
  constexpr double kSmallPart = 0.01;  // of the points; a camera that is best for fewer is left out
  constexpr double kRadii = 3.0;
  Bounds bounds;
  for (const Vector3& p : readings.points) {
    bounds.lower = bounds.lower.cwiseMin(p);
    bounds.upper = bounds.upper.cwiseMax(p);
  }
  const double away = kRadii * std::max(0.5 * bounds.size().norm(), 1e-3);
  const std::vector<Vector3> directions = directions_around();
  std::vector<std::size_t> best_of(directions.size(), 0);
  for (const Vector3& normal : readings.normals) {
    const auto nearer = [&](const Vector3& a, const Vector3& b) {
      return normal.dot(a) < normal.dot(b);
    };
    const auto best = std::max_element(directions.begin(), directions.end(), nearer);
    ++best_of[static_cast<std::size_t>(best - directions.begin())];
  }
  std::vector<DepthView> views;
  for (std::size_t d = 0; d < directions.size(); ++d) {
    if (static_cast<double>(best_of[d]) < kSmallPart * static_cast<double>(readings.points.size()))
      continue;
    const Pose X_FC = looking_along(-directions[d], bounds.center() + away * directions[d]);
    std::vector<char> wanted;
    for (const Vector3& normal : readings.normals) {
      wanted.push_back(normal.dot(directions[d]) > kFaces ? 1 : 0);
    }
    const std::vector<Ray> rays = rays_from(X_FC, readings.points, &wanted);
    if (!rays.empty()) views.push_back(image_of(rays, X_WF * X_FC));
  }
  return views;
}

// Whether most normals that are known face the viewpoint.
bool face(const Readings& readings, const Vector3& viewpoint) {
  std::ptrdiff_t towards = 0;
  for (std::size_t i = 0; i < readings.points.size(); ++i) {
    const double cosine = readings.normals[i].dot(viewpoint - readings.points[i]);
    towards += cosine > 0.0 ? 1 : (cosine < 0.0 ? -1 : 0);
  }
  return towards > 0;
}

// The straight line through (slope, pixel) with the least squares: pixel = f slope + c.
struct PixelLine {
  double n = 0.0;
  double s = 0.0;
  double p = 0.0;
  double ss = 0.0;
  double sp = 0.0;

  void add(double slope, double pixel) {
    n += 1.0;
    s += slope;
    p += pixel;
    ss += slope * slope;
    sp += slope * pixel;
  }
  double focal() const { return (n * sp - s * p) / (n * ss - s * s); }
  double middle() const { return (p - focal() * s) / n; }
};

// The points of an organised cloud in the frame of its camera, X_FC, as its image; nothing where no
// pinhole camera has seen them so.
std::optional<DepthView> grid_view(const PointCloud& cloud, double unit, const Pose& X_FC) {
  constexpr double kNear = 0.3;  // pixels
  const Pose X_CF = X_FC.inverse();
  PixelLine across;
  PixelLine down;
  DepthView view;
  view.depth.assign(cloud.points.size(), 0.0F);
  std::vector<Ray> rays(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Vector3 p = X_CF * Vector3(unit * cloud.points[i].cast<double>());
    if (!p.allFinite() || p.norm() == 0.0) continue;
    if (p.z() <= 0.0) return {};
    rays[i] = {p.x() / p.z(), p.y() / p.z(), p.z()};
    view.depth[i] = static_cast<float>(p.z());
    across.add(rays[i].x, static_cast<double>(i % cloud.width));
    const std::size_t row = i / cloud.width;
    down.add(rays[i].y, static_cast<double>(row));
  }
  view.camera = {across.focal(),
                 down.focal(),
                 across.middle(),
                 down.middle(),
                 static_cast<int>(cloud.width),
                 static_cast<int>(cloud.height),
                 X_FC};
  const DepthCamera& camera = view.camera;
  if (!(camera.fx > 0.0) || !(camera.fy > 0.0) || !std::isfinite(camera.cx + camera.cy)) return {};
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays[i].z == 0.0) continue;
    const double u = camera.fx * rays[i].x + camera.cx;
    const double v = camera.fy * rays[i].y + camera.cy;
    if (!(std::abs(u - static_cast<double>(i % cloud.width)) <= kNear)) return {};
    const std::size_t row = i / cloud.width;
    if (!(std::abs(v - static_cast<double>(row)) <= kNear)) return {};
  }
  return view;
}

// With the axes of the file's frame, as cameras write them, or turned as its viewpoint says.
std::optional<DepthView> organised_view(const PointCloud& cloud, const CloudPlace& place,
                                        const Vector3& viewpoint) {
  if (cloud.height < 2 || cloud.width < 2) return {};
  std::optional<DepthView> view = grid_view(cloud, place.metres_per_unit, translation(viewpoint));
  if (!view && cloud.X_FV) {
    view = grid_view(cloud, place.metres_per_unit, pose_from(cloud.X_FV->linear(), viewpoint));
  }
  if (view) view->camera.X_WC = place.X_WF * view->camera.X_WC;
  return view;
}

void drop_readings_at(const Vector3& viewpoint, Readings& readings) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < readings.points.size(); ++i) {
    if (readings.points[i] == viewpoint) continue;
    readings.points[kept] = readings.points[i];
    if (!readings.normals.empty()) readings.normals[kept] = readings.normals[i];
    ++kept;
  }
  readings.points.resize(kept);
  if (!readings.normals.empty()) readings.normals.resize(kept);
}

void require_distances(const Readings& readings, const Vector3& viewpoint) {
  std::vector<float> distances;
  distances.reserve(readings.points.size());
  for (const Vector3& p : readings.points) {
    distances.push_back(static_cast<float>((p - viewpoint).norm()));
  }
  require_plausible(distances);
}

}  // namespace

std::vector<DepthView> views_of_cloud(const PointCloud& cloud, const CloudPlace& place,
                                      std::vector<std::string>& notes) {
  Readings readings = readings_of(cloud, place.metres_per_unit, notes);
  std::optional<Vector3> viewpoint = place.viewpoint;
  if (!viewpoint && cloud.X_FV) viewpoint = place.metres_per_unit * cloud.X_FV->translation();
  if (!viewpoint && readings.normals.empty()) {
    viewpoint = Vector3::Zero();
    notes.emplace_back(
        "nobody says where the camera stood: at the origin, unless viewpoint is stated");
  }
  if (viewpoint && !place.viewpoint && !readings.normals.empty() && !face(readings, *viewpoint)) {
    viewpoint.reset();
  }
  if (viewpoint) {
    drop_readings_at(*viewpoint, readings);
    require_distances(readings, *viewpoint);
    if (auto view = organised_view(cloud, place, *viewpoint)) return {std::move(*view)};
    return views_from(*viewpoint, readings, place.X_WF);
  }
  Vector3 middle = Vector3::Zero();
  for (const Vector3& p : readings.points)
    middle += p / static_cast<double>(readings.points.size());
  require_distances(readings, middle);
  std::vector<DepthView> views = views_around(readings, place.X_WF);
  require(!views.empty(), {.problem = "no viewpoint, and no normal: state the viewpoint"});
  notes.push_back(
      formatted("no viewpoint that the normals face: seen by %zu cameras around", views.size()));
  return views;
}

}  // namespace prehend
