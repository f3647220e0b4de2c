#include "primitives/region.h"

#include <array>
#include <cmath>
#include <limits>

#include "primitives/fit_box.h"
#include "primitives/fit_cylinder.h"
#include "primitives/fit_sphere.h"
#include "primitives/primitive_surface.h"

namespace prehend {

double phantom_cost(const Primitive& primitive, const Surface& surface) {
  constexpr double kPhantomWeight = 0.8;
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
  constexpr std::size_t kQuickPoints = 160;
  constexpr int kQuickSteps = 4;
  constexpr int kThoroughSteps = 12;
  constexpr double kMinExtent = 1e-4;
  const bool quick = effort == Effort::kQuick;
  const FitOptions options{.outlier = surface.tolerance,
                           .min_extent = kMinExtent,
                           .steps = quick ? kQuickSteps : kThoroughSteps,
                           .thorough = !quick};
  const std::vector<SurfacePoint> few = quick ? thinned(points, kQuickPoints) : points;
  const double share =
      static_cast<double>(points.size()) / static_cast<double>(surface.points.size());
  Region region;
  region.cost = std::numeric_limits<double>::infinity();
  for (const Primitive& candidate :
       {fit_cylinder(few, options), fit_box(few, options), fit_sphere(few, options)}) {
    const double cost =
        share * misfit(few, candidate, surface.tolerance) + phantom_cost(candidate, surface);
    if (cost < region.cost) {
      region.primitive = candidate;
      region.cost = cost;
    }
  }
  std::size_t unexplained = 0;
  for (const SurfacePoint& s : points) {
    if (std::abs(signed_distance(region.primitive, s.p_O)) > surface.tolerance) ++unexplained;
  }
  region.unexplained =
      static_cast<double>(unexplained) / static_cast<double>(surface.points.size());
  region.points = std::move(points);
  return region;
}

}  // namespace prehend
