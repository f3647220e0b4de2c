#include "primitives/region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "primitives/fit_shapes.h"
#include "primitives/primitive_surface.h"
#include "sim/base/parallel/parallel.h"

// What a region costs is its part of the objective (region.h): the misfit of its points, weighted
// with their share of the surface, and the phantom surface of its primitive. All three kinds of
// primitive are fitted to the same points, and the cheapest one is kept.
namespace prehend {
namespace {

// What the primitive costs when `points` stand for `share` of the surface.
double cost_of(const Primitive& primitive, std::span<const SurfacePoint> points, double share,
               const Surface& surface) {
  return share * misfit(points, primitive, surface.tolerance) + phantom_cost(primitive, surface);
}

// Points beyond the tolerance, as a share of all points of the surface.
double unexplained_share(const Primitive& primitive, std::span<const SurfacePoint> points,
                         const Surface& surface) {
  const auto unexplained = std::count_if(points.begin(), points.end(), [&](const SurfacePoint& s) {
    return std::abs(signed_distance(primitive, s.p_O)) > surface.tolerance;
  });
  return static_cast<double>(unexplained) / static_cast<double>(surface.whole);
}

// Lengths are in the unit of the scaled mesh, whose bounding box has a diagonal of 1.
constexpr double kMinExtent = 1e-4;

using FitShape = Primitive (*)(std::span<const SurfacePoint>, const FitOptions&);
constexpr std::array<FitShape, 3> kShapes = {fit_cylinder, fit_box, fit_sphere};

Fit fit_of(FitShape fit, std::span<const SurfacePoint> points, double share,
           const FitOptions& options, const Surface& surface) {
  surface.cancellation.check();
  const Primitive primitive = fit(points, options);
  return {primitive, cost_of(primitive, points, share, surface)};
}

// The first of those that cost least.
Fit cheapest(std::span<const Fit> fits) {
  return *std::min_element(fits.begin(), fits.end(),
                           [](const Fit& a, const Fit& b) { return a.cost < b.cost; });
}

}  // namespace

// The area of the patches of the primitive that are not near the mesh, relative to the area of the
// mesh.
double phantom_cost(const Primitive& primitive, const Surface& surface) {
  constexpr double kPhantomWeight = 0.6;
  constexpr int kPatches = 160;
  double phantom = 0.0;
  for (const PatchPoint& patch : spread_points(primitive, kPatches)) {
    if (!surface.near.near(patch.p_O)) phantom += patch.area;
  }
  return kPhantomWeight * phantom / surface.area;
}

double share_of(std::size_t count, const Surface& surface) {
  return static_cast<double>(count) / static_cast<double>(surface.whole);
}

std::vector<std::vector<SurfacePoint>> points_by_nearest(const std::vector<Region>& regions,
                                                         const Surface& surface) {
  std::vector<std::vector<SurfacePoint>> points(regions.size());
  for (const SurfacePoint& s : surface.points) {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < regions.size(); ++k) {
      const double distance = std::abs(signed_distance(regions[k].fit.primitive, s.p_O));
      if (distance >= least) continue;
      least = distance;
      nearest = k;
    }
    points[nearest].push_back(s);
  }
  return points;
}

std::vector<double> distances(const Primitive& primitive, std::span<const SurfacePoint> points) {
  std::vector<double> result;
  result.reserve(points.size());
  for (const SurfacePoint& s : points) {
    result.push_back(std::abs(signed_distance(primitive, s.p_O)));
  }
  return result;
}

Fit quick_fit(std::span<const SurfacePoint> points, double share, const Surface& surface) {
  constexpr int kSteps = 4;
  const FitOptions options{
      .outlier = surface.tolerance, .min_extent = kMinExtent, .steps = kSteps, .thorough = false};
  std::array<Fit, kShapes.size()> fits;
  for (std::size_t i = 0; i < kShapes.size(); ++i) {
    fits[i] = fit_of(kShapes[i], points, share, options, surface);
  }
  return cheapest(fits);
}

std::vector<Region> fit_regions(std::vector<std::vector<SurfacePoint>> parts,
                                const Surface& surface) {
  constexpr int kSteps = 12;
  const FitOptions options{
      .outlier = surface.tolerance, .min_extent = kMinExtent, .steps = kSteps, .thorough = true};
  constexpr std::size_t kKinds = kShapes.size();
  std::vector<Fit> fits(kKinds * parts.size());
  for_each_in_parallel(fits.size(), surface.threads, [&](std::size_t i) {
    const std::vector<SurfacePoint>& points = parts[i / kKinds];
    fits[i] =
        fit_of(kShapes[i % kKinds], points, share_of(points.size(), surface), options, surface);
  });
  std::vector<Region> regions;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    Region region{std::move(parts[k]), cheapest(std::span(fits).subspan(kKinds * k, kKinds)), 0.0};
    region.unexplained = unexplained_share(region.fit.primitive, region.points, surface);
    regions.push_back(std::move(region));
  }
  return regions;
}

std::vector<Region> refitted(std::vector<std::vector<SurfacePoint>> parts,
                             const std::vector<Primitive>& primitives, const Surface& surface) {
  std::vector<Region> regions = fit_regions(std::move(parts), surface);
  for (std::size_t k = 0; k < regions.size(); ++k) {
    Region& region = regions[k];
    const double share = share_of(region.points.size(), surface);
    const double cost = cost_of(primitives[k], region.points, share, surface);
    if (region.fit.cost <= cost) continue;
    region.fit = {primitives[k], cost};
    region.unexplained = unexplained_share(primitives[k], region.points, surface);
  }
  return regions;
}

}  // namespace prehend
