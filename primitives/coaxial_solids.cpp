#include "primitives/coaxial_solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace prehend {
namespace {

// Lengths are in the unit of the scaled mesh, whose bounding box has a diagonal of 1.

// The price of a solid, and of its numbers beyond those of a cylinder.
constexpr double kSolidCost = 0.03;
constexpr double kShapeCost = 0.006;
// A cone's radii differ by at least this part of their mean: less is a cylinder for a hand.
constexpr double kLeastConeTaper = 0.15;
// Of a sphere at least this part of its length is there.
constexpr double kLeastOfSphere = 0.5;
constexpr double kMissingWeight = 0.6;  // as phantom_cost (region.h)

// Weighted sums over steps of a profile: z along the axis, r the radius, q = z^2 + r^2.
struct ProfileSums {
  double w = 0.0;
  double z = 0.0, r = 0.0, q = 0.0;
  double zz = 0.0, zr = 0.0, zq = 0.0;
  double rr = 0.0, qq = 0.0;

  void add(double weight, double along, double radius) {
    const double square = along * along + radius * radius;
    w += weight;
    z += weight * along;
    r += weight * radius;
    q += weight * square;
    zz += weight * along * along;
    zr += weight * along * radius;
    zq += weight * along * square;
    rr += weight * radius * radius;
    qq += weight * square * square;
  }

  ProfileSums operator-(const ProfileSums& b) const {
    return {w - b.w,   z - b.z,   r - b.r,   q - b.q,  zz - b.zz,
            zr - b.zr, zq - b.zq, rr - b.rr, qq - b.qq};
  }

  double spread() const { return zz - z * z / w; }
};

// Where a solid lies on the axis.
struct Stretch {
  double low = 0.0;
  double high = 0.0;
};

// What costs are relative to.
struct CostScale {
  double area = 0.0;
  double tolerance = 0.0;

  double misfit(double squared_error) const {
    return std::max(squared_error, 0.0) / (tolerance * tolerance);
  }
};

// The radius as a line over z.
struct RadiusLine {
  double at_zero = 0.0;
  double slope = 0.0;

  double at(double z) const { return at_zero + slope * z; }
};

// A solid that explains a stretch: a cylinder or a cone by its radius, a sphere by its place.
struct Solid {
  std::optional<RadiusLine> side = {};
  double center = 0.0;  // of a sphere
  double radius = 0.0;
  Stretch stretch = {};
  double misfit = 0.0;
  double price = std::numeric_limits<double>::infinity();

  double cost() const { return misfit + price; }
};

Solid cylinder_over(const ProfileSums& s, const CostScale& scale) {
  const double radius = s.r / s.w;
  return {.side = RadiusLine{radius, 0.0},
          .misfit = scale.misfit(s.rr - radius * s.r),
          .price = kSolidCost};
}

std::optional<Solid> cone_over(const ProfileSums& s, Stretch over, const CostScale& scale) {
  const double slope = (s.zr - s.z * s.r / s.w) / s.spread();
  const RadiusLine line{(s.r - slope * s.z) / s.w, slope};
  const double mean = 0.5 * (line.at(over.low) + line.at(over.high));
  const double taper = std::abs(line.at(over.high) - line.at(over.low));
  if (!(taper > kLeastConeTaper * mean)) return std::nullopt;
  return Solid{.side = line,
               .misfit = scale.misfit(s.rr - line.at_zero * s.r - slope * s.zr),
               .price = kSolidCost + kShapeCost};
}

// On a sphere about c, q = 2 c z + radius^2 - c^2, a line over z; a distance d from it changes q by
// 2 radius d.
std::optional<Solid> sphere_over(const ProfileSums& s, Stretch over, const CostScale& scale) {
  const double slope = (s.zq - s.z * s.q / s.w) / s.spread();
  const double at_zero = (s.q - slope * s.z) / s.w;
  const double center = 0.5 * slope;
  const double squared = at_zero + center * center;
  if (!(squared > 0.0)) return std::nullopt;
  const double radius = std::sqrt(squared);
  const double there = std::min(over.high, center + radius) - std::max(over.low, center - radius);
  const double part = std::min(there / (2.0 * radius), 1.0);
  if (part < kLeastOfSphere) return std::nullopt;
  const double missing = (1.0 - part) * 4.0 * std::numbers::pi * squared / scale.area;
  const double error = (s.qq - at_zero * s.q - slope * s.zq) / (4.0 * squared);
  return Solid{.center = center,
               .radius = radius,
               .misfit = scale.misfit(error),
               .price = kSolidCost + kShapeCost + kMissingWeight * missing};
}

Solid best_solid(const ProfileSums& sums, Stretch over, const CostScale& scale) {
  constexpr double kLeastSpread = 1e-12;
  Solid best = cylinder_over(sums, scale);
  if (sums.spread() > kLeastSpread) {
    for (const std::optional<Solid>& other :
         {cone_over(sums, over, scale), sphere_over(sums, over, scale)}) {
      if (other && other->cost() < best.cost()) best = *other;
    }
  }
  best.stretch = over;
  return best;
}

Primitive on_axis(const Solid& solid, const TurnAxis& axis) {
  Primitive primitive{Sphere{solid.radius}, Pose::Identity()};
  double middle = solid.center;
  if (solid.side) {
    const auto [low, high] = solid.stretch;
    const double below = std::max(solid.side->at(low), 0.0);
    const double above = std::max(solid.side->at(high), 0.0);
    middle = 0.5 * (low + high);
    if (below == above) {
      primitive.shape = Cylinder{below, high - low};
    } else {
      primitive.shape = Cone{below, above, high - low};
    }
  }
  const Vector3& z = axis.direction_O;
  const Vector3 x = z.unitOrthogonal();
  primitive.X_OP.linear() << x, z.cross(x), z;
  primitive.X_OP.translation() = axis.p_O + middle * z;
  return primitive;
}

// Of the first steps of a profile: the least cost, and the last solid of it.
struct ExplainedSteps {
  double cost = 0.0;
  std::size_t from = 0;  // where the last solid, or the step without one, begins
  std::optional<Solid> last = {};
};

// Where two solids that follow each other meet: not at the border of a step, but where the profile
// is as far from the one as from the other. Borders of steps would move by a whole step where the
// axis moves by nothing.
void move_border(const TurnProfile& profile, std::size_t border, Solid& below, Solid& above) {
  constexpr std::size_t kReach = 2;
  if (!below.side || !above.side) return;
  const auto middle = [&](std::size_t k) { return profile.at(k) + 0.5 * profile.step; };
  // By how much farther from the lower one.
  const auto farther = [&](std::size_t k) {
    return std::abs(profile.radius[k] - below.side->at(middle(k))) -
           std::abs(profile.radius[k] - above.side->at(middle(k)));
  };
  const std::size_t first = border > kReach ? border - kReach : 0;
  const std::size_t last = std::min(border + kReach, TurnProfile::kSteps) - 1;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = first; k < last; ++k) {
    if (!(profile.share[k] > 0.0 && profile.share[k + 1] > 0.0)) continue;
    const double here = farther(k);
    const double next = farther(k + 1);
    if (!(here <= 0.0 && next > 0.0)) continue;
    const double z = middle(k) + profile.step * here / (here - next);
    if (std::abs(z - profile.at(border)) >= nearest) continue;
    if (z <= below.stretch.low || z >= above.stretch.high) continue;
    nearest = std::abs(z - profile.at(border));
    below.stretch.high = z;
    above.stretch.low = z;
  }
}

}  // namespace

CoaxialSolids best_coaxial_solids(const TurnAxis& axis, const TurnProfile& profile, double area,
                                  double tolerance) {
  constexpr std::size_t kSteps = TurnProfile::kSteps;
  const CostScale scale{area, tolerance};
  std::array<ProfileSums, kSteps + 1> below;
  for (std::size_t k = 0; k < kSteps; ++k) {
    below[k + 1] = below[k];
    if (!(profile.share[k] > 0.0)) continue;
    below[k + 1].add(profile.share[k], profile.at(k) + 0.5 * profile.step, profile.radius[k]);
  }
  std::array<ExplainedSteps, kSteps + 1> best;
  for (std::size_t end = 1; end <= kSteps; ++end) {
    best[end] = {best[end - 1].cost + profile.share[end - 1], end - 1};
    if (!(profile.share[end - 1] > 0.0)) continue;
    for (std::size_t from = 0; from < end; ++from) {
      if (!(profile.share[from] > 0.0)) continue;
      const Stretch over{profile.at(from), profile.at(end)};
      const Solid solid = best_solid(below[end] - below[from], over, scale);
      if (best[from].cost + solid.cost() >= best[end].cost) continue;
      best[end] = {best[from].cost + solid.cost(), from, solid};
    }
  }
  CoaxialSolids found{.solids = {},
                      .explained = below[kSteps].w - best[kSteps].cost,
                      .gain = below[kSteps].w - best[kSteps].cost};
  std::vector<Solid> solids;  // from high to low
  for (std::size_t end = kSteps; end > 0; end = best[end].from) {
    if (!best[end].last) continue;
    const bool follows = !solids.empty() && solids.back().stretch.low == profile.at(end);
    solids.push_back(*best[end].last);
    found.explained += solids.back().price;
    if (follows) move_border(profile, end, solids.back(), solids[solids.size() - 2]);
  }
  for (auto solid = solids.rbegin(); solid != solids.rend(); ++solid) {
    found.solids.push_back(on_axis(*solid, axis));
  }
  return found;
}

namespace {

// The axis in the direction in which fewer points reach farther (third moment), so that turning an
// object does not turn the axis around.
TurnAxis towards_the_tail(TurnAxis axis, const std::vector<SurfacePoint>& points) {
  double mean = 0.0;
  for (const SurfacePoint& s : points) mean += s.p_O.dot(axis.direction_O);
  mean /= static_cast<double>(points.size());
  double moment = 0.0;
  for (const SurfacePoint& s : points) {
    const double along = s.p_O.dot(axis.direction_O) - mean;
    moment += along * along * along;
  }
  if (moment < 0.0) axis.direction_O = -axis.direction_O;
  return axis;
}

// The profile from the axis on which it is centered, in at most so many steps.
TurnProfile centered_profile(TurnAxis& axis, const Surface& surface, int steps) {
  constexpr double kStill = 1e-9;
  TurnProfile profile = turn_profile(axis, surface.points, surface.whole);
  for (int i = 0; i < steps; ++i) {
    const TurnAxis next = centered(axis, profile, surface.points);
    const double change =
        (next.p_O - axis.p_O).norm() + (next.direction_O - axis.direction_O).norm();
    axis = next;
    profile = turn_profile(axis, surface.points, surface.whole);
    if (change < kStill) break;
  }
  return profile;
}

// The solids about the axis for which they gain most.
CoaxialSolids best_of_axes(const Surface& surface) {
  constexpr int kQuickSteps = 3;
  constexpr int kSteps = 12;
  // Radii are means of many points: they are worth more than a single one's distance.
  const double tolerance = 0.4 * surface.tolerance;
  constexpr double kClearly = 1.03;
  TurnAxis best_axis;
  double best_gain = 0.0;
  for (TurnAxis axis : likely_axes(surface.points)) {
    surface.cancellation.check();
    axis = towards_the_tail(axis, surface.points);
    const TurnProfile profile = centered_profile(axis, surface, kQuickSteps);
    const double gain = best_coaxial_solids(axis, profile, surface.area, tolerance).gain;
    // Of a ball all axes are alike: the first ones are those of the whole object.
    if (gain <= kClearly * best_gain) continue;
    best_gain = gain;
    best_axis = axis;
  }
  if (!(best_gain > 0.0)) return {};
  const TurnProfile profile = centered_profile(best_axis, surface, kSteps);
  return best_coaxial_solids(best_axis, profile, surface.area, tolerance);
}

}  // namespace

std::vector<Region> take_coaxial_solids(Surface& surface) {
  constexpr int kMostAxes = 3;
  constexpr std::size_t kFewest = 50;
  // Less is better explained by what is fitted to patches: a few steps of anything look round.
  constexpr double kLeastExplained = 0.3;
  const double near = 0.5 * surface.tolerance;
  std::vector<Region> regions;
  for (int k = 0; k < kMostAxes && surface.points.size() >= kFewest; ++k) {
    const CoaxialSolids found = best_of_axes(surface);
    if (found.explained < kLeastExplained) break;
    const std::size_t first = regions.size();
    for (const Primitive& solid : found.solids) regions.push_back({{}, {solid, 0.0}, 0.0, true});
    std::vector<SurfacePoint> left;
    for (const SurfacePoint& s : surface.points) {
      double distance = std::numeric_limits<double>::infinity();
      bool inside = false;
      std::size_t nearest = first;
      for (std::size_t i = first; i < regions.size(); ++i) {
        const double d = signed_distance(regions[i].fit.primitive, s.p_O);
        inside = inside || d < 0.0;
        if (std::abs(d) >= distance) continue;
        distance = std::abs(d);
        nearest = i;
      }
      (inside || distance < near ? regions[nearest].points : left).push_back(s);
    }
    surface.points = std::move(left);
  }
  return regions;
}

}  // namespace prehend
