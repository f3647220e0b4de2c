#include "primitives/thin_parts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "primitives/own_frame.h"
#include "primitives/spot_curves.h"
#include "primitives/surface_sample.h"
#include "primitives/wall_spots.h"
#include "sim/base/index.h"
#include "sim/base/require_settings.h"

namespace prehend {
namespace {

// Lengths relative to the diagonal of the bounding box.
constexpr double kReach = 0.1;  // as in ThinLimits, also the next three
constexpr double kFreeAhead = 0.2;
constexpr double kFreeBeside = 0.04;
constexpr double kAround = 0.3;
constexpr double kLink = 0.08;      // between spots of one curve
constexpr double kShortest = 0.15;  // curve
constexpr double kDeepest = 0.12;   // what counts of the depth of a wall

// A curve is at least so many times as long as it is wide.
constexpr double kSlender = 3.0;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_width(const SpotCurve& curve) {
  std::vector<double> widths;
  for (const ThinSpot& spot : curve.places) widths.push_back(spot.width);
  return median(std::move(widths));
}

double median_depth(const SpotCurve& curve) {
  std::vector<double> depths;
  for (const ThinSpot& spot : curve.places) depths.push_back(spot.depth);
  return median(std::move(depths));
}

bool about_equal(double a, double b) { return a < 1.5 * b && b < 1.5 * a; }

// Whether the size across which a rim or bar would be held is one of the solid as well.
bool has_width(const Shape& solid, double width, bool is_bar) {
  if (const auto* box = std::get_if<Box>(&solid)) {
    Vector3 size = box->size;
    std::sort(size.begin(), size.end());
    return about_equal(is_bar ? size[1] : size[0], width);
  }
  if (const auto* cylinder = std::get_if<Cylinder>(&solid)) {
    return about_equal(is_bar ? 2.0 * cylinder->radius : cylinder->height, width);
  }
  return false;
}

bool is_described(const SpotCurve& curve, const std::vector<Primitive>& solids, bool is_bar) {
  constexpr double kMost = 0.7;
  const double width = median_width(curve);
  return std::any_of(solids.begin(), solids.end(), [&](const Primitive& solid) {
    if (!has_width(solid.shape, width, is_bar)) return false;
    const auto inside = std::count_if(
        curve.places.begin(), curve.places.end(),
        [&](const ThinSpot& spot) { return signed_distance(solid, spot.p) < 0.5 * width; });
    return static_cast<double>(inside) > kMost * static_cast<double>(curve.places.size());
  });
}

Primitive rim_of(const SpotCurve& curve, double deepest) {
  Rim rim;
  for (const ThinSpot& spot : curve.places) rim.points.push_back({spot.p, spot.into, spot.across});
  rim.width = median_width(curve);
  rim.depth = std::min(median_depth(curve), deepest);
  rim.closed = curve.closed;
  return {rim, Pose::Identity()};
}

Primitive bar_of(const SpotCurve& curve) {
  Bar bar;
  for (const ThinSpot& spot : curve.places) bar.points.push_back(spot.p);
  bar.width = median_width(curve);
  bar.closed = curve.closed;
  return {bar, Pose::Identity()};
}

// The longest curves through the spots that no solid describes.
std::vector<SpotCurve> telling_curves(const std::vector<ThinSpot>& spots,
                                      const std::vector<Primitive>& solids, double diagonal,
                                      int most, bool is_bar) {
  std::vector<SpotCurve> curves = spot_curves(spots, kLink * diagonal, kShortest * diagonal);
  std::erase_if(curves, [&](const SpotCurve& curve) {
    return curve.length < kSlender * median_width(curve) || is_described(curve, solids, is_bar);
  });
  if (curves.size() > index(most)) curves.resize(index(most));
  return curves;
}

}  // namespace

std::vector<Primitive> find_thin_parts(const ProximityMesh& mesh,
                                       const std::vector<Primitive>& solids,
                                       const ThinPartOptions& options, const RunContext& context) {
  require_settings(options);
  const OwnFrame own = own_frame(mesh.mesh());
  const double diagonal = own.diagonal;
  if (!(diagonal > 0.0 && std::isfinite(diagonal))) return {};
  const ThinLimits limits{.wall = options.rim_width * diagonal,
                          .bar = options.bar_width * diagonal,
                          .reach = kReach * diagonal,
                          .free_ahead = kFreeAhead * diagonal,
                          .free_beside = kFreeBeside * diagonal,
                          .around = kAround * diagonal};
  const std::vector<SurfacePoint> points =
      sample_surface(mesh.mesh(), options.points, options.seed, own.X_OA.linear());
  const ThinSpots spots = find_thin_spots(mesh, points, limits, context);
  std::vector<Primitive> parts;
  for (const SpotCurve& curve :
       telling_curves(spots.walls, solids, diagonal, options.most_rims, false)) {
    parts.push_back(rim_of(curve, kDeepest * diagonal));
  }
  for (const SpotCurve& curve :
       telling_curves(spots.bars, solids, diagonal, options.most_bars, true)) {
    parts.push_back(bar_of(curve));
  }
  return parts;
}

}  // namespace prehend
