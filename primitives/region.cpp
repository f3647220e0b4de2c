#include "primitives/region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "primitives/fit_shapes.h"
#include "primitives/primitive_surface.h"

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
  return static_cast<double>(unexplained) / static_cast<double>(surface.points.size());
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

std::vector<double> distances(const Primitive& primitive, const Surface& surface) {
  std::vector<double> result;
  result.reserve(surface.points.size());
  for (const SurfacePoint& s : surface.points) {
    result.push_back(std::abs(signed_distance(primitive, s.p_O)));
  }
  return result;
}

Region fit_region(std::vector<SurfacePoint> points, const Surface& surface, Effort effort) {
  // Quick fits use few points and few steps: a search for splits compares many candidates, and only
  // the best one is fitted again thoroughly (refitted). Lengths are in the unit of the scaled mesh,
  // whose bounding box has a diagonal of 1.
  constexpr std::size_t kQuickPoints = 160;
  constexpr int kQuickSteps = 4;
  constexpr int kThoroughSteps = 12;
  constexpr double kMinExtent = 1e-4;
  const bool quick = effort == Effort::quick;
  const FitOptions options{.outlier = surface.tolerance,
                           .min_extent = kMinExtent,
                           .steps = quick ? kQuickSteps : kThoroughSteps,
                           .thorough = !quick};
  const std::vector<SurfacePoint> few = quick ? thinned(points, kQuickPoints) : points;
  const double share =
      static_cast<double>(points.size()) / static_cast<double>(surface.points.size());
  Region region;
  region.cost = std::numeric_limits<double>::infinity();
  for (const auto fit : {fit_cylinder, fit_box, fit_sphere}) {
    surface.cancellation.check();
    const Primitive candidate = fit(few, options);
    const double cost = cost_of(candidate, few, share, surface);
    if (cost < region.cost) {
      region.primitive = candidate;
      region.cost = cost;
    }
  }
  region.unexplained = unexplained_share(region.primitive, points, surface);
  region.points = std::move(points);
  return region;
}

Region refitted(Region region, const Surface& surface) {
  const double share =
      static_cast<double>(region.points.size()) / static_cast<double>(surface.points.size());
  region.cost = cost_of(region.primitive, region.points, share, surface);
  Region thorough = fit_region(region.points, surface, Effort::thorough);
  return thorough.cost <= region.cost ? std::move(thorough) : std::move(region);
}

}  // namespace prehend
