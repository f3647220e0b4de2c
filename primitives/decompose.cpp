#include "primitives/decompose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "primitives/align.h"
#include "primitives/closest_fit.h"
#include "primitives/coaxial_solids.h"
#include "primitives/fit.h"
#include "primitives/inscribed.h"
#include "primitives/own_frame.h"
#include "primitives/polish.h"
#include "primitives/quantile.h"
#include "primitives/smoothed_points.h"
#include "primitives/split.h"
#include "primitives/taper.h"
#include "sim/base/formatted.h"
#include "sim/base/input_error.h"
#include "sim/base/parallel/parallel.h"
#include "sim/base/require_settings.h"
#include "sim/shape/mesh_checks.h"

namespace prehend {
namespace {

// Stages: scale the mesh to unit size, sample points from it, take what turns about an axis
// (coaxial_solids.h), split the rest greedily from the whole down (grown), improve the pieces as a
// set (polished), drop to the number allowed (reduced), make cones of cylinders that taper, bring
// each as close to its points as it gets (come_closest), then correct radii for tessellation and
// scale back.

// Throws InputError for options out of range and meshes with unusable indices or vertices.
void check(const TriangleMesh& mesh, const DecomposeOptions& options) {
  require_settings(options);
  require_valid_indices(mesh, "mesh");
  for (const Triangle& t : mesh.triangles) {
    for (const int v : t) {
      if (mesh.vertices[static_cast<std::size_t>(v)].allFinite()) continue;
      throw InputError(
          {.field = "mesh.vertices[" + std::to_string(v) + "]", .problem = "not finite"});
    }
  }
}

InputErrorParts no_area(const TriangleMesh& mesh) {
  return {.field = "mesh",
          .problem = "no area",
          .value = std::to_string(mesh.triangles.size()) + " triangles"};
}

// The mesh in its own frame, moved and scaled so that its box there has its middle at 0 and a
// diagonal of 1. All thresholds of the decomposition are meant for that size, and all starts of
// fits are directions of that frame, so that neither units nor the frame of the file matter.
struct UnitMesh {
  TriangleMesh mesh;
  Pose X_OU = Pose::Identity();  // of the unit frame, before scaling
  double diagonal = 0.0;
};

UnitMesh unit_mesh(const TriangleMesh& mesh) {
  const OwnFrame own = own_frame(mesh);
  require(own.diagonal > 0.0 && std::isfinite(own.diagonal), no_area(mesh));
  UnitMesh unit{mesh, own.X_OA * translation(own.center_A), own.diagonal};
  const Pose X_UO = unit.X_OU.inverse();
  for (Vector3& p : unit.mesh.vertices) p = X_UO * p / unit.diagonal;
  return unit;
}

// The surface as decisions see it, and as sizes are taken from it.
struct Surfaces {
  Surface smooth;
  Surface exact;
};

Surfaces surfaces_of(const TriangleMesh& mesh, const DecomposeOptions& options,
                     const RunContext& context) {
  // Surface of a primitive counts as phantom when it is farther from the mesh than the tolerance.
  // The radius must also exceed the spacing of the points, or holes between them would look like
  // missing surface, and must not make the voxel grid too fine (memory).
  constexpr double kGaps = 2.0;
  constexpr double kFinestGrid = 0.02;
  // Normals and positions are means over this distance, of so many times more points: noise of a
  // hundredth of the object and triangles as large as that hardly matter then.
  constexpr double kSmoothing = 0.045;
  constexpr int kMorePoints = 3;
  const std::vector<SurfacePoint> rough =
      sample_surface(mesh, kMorePoints * options.points, options.seed);
  require(!rough.empty(), no_area(mesh));
  SmoothedPoints points =
      smoothed_points(rough, kSmoothing, static_cast<std::size_t>(options.points), context.threads);
  require(!points.exact.empty(), no_area(mesh));
  const double area = surface_area(mesh);
  const double gap = std::sqrt(area / options.points);
  const double radius = std::max({options.tolerance, kGaps * gap, kFinestGrid});
  const auto surface = [&](std::vector<SurfacePoint> of) {
    NearSurface near(of, radius);
    const std::size_t whole = of.size();
    return Surface{std::move(of),   std::move(near),     area,
                   whole,           options.tolerance,   options.coverage,
                   context.threads, context.cancellation};
  };
  return {surface(std::move(points.smooth)), surface(std::move(points.exact))};
}

// A region of the present partition, with its best split once that has been looked for.
struct Leaf {
  Region region;
  bool tried = false;
  std::optional<Split> split;

  // By how much the split lowers the objective, apart from the shortfall of coverage.
  double gain() const { return split ? region.fit.cost - split->cost() - kPieceCost : -1.0; }
  // The share of the whole surface that only the split explains.
  double newly_explained() const {
    return split ? region.unexplained - split->first.unexplained - split->second.unexplained : -1.0;
  }
};

// Greedy top-down clustering. It begins with one region, the whole surface; the split that lowers
// the objective most is carried out, until none lowers it. The best split of a region does not
// depend on other regions, so it is computed once; only the reward for coverage depends on them,
// and is added when the splits are compared.
std::vector<Region> grown(const Surface& surface, const DecomposeOptions& options) {
  // More pieces than asked for: merging afterwards (polished, reduced) finds a better set of few
  // pieces than stopping early does, because early cuts are made without knowing the later ones.
  const std::size_t most = static_cast<std::size_t>(options.max_primitives) + 4;
  std::vector<Leaf> leaves;
  leaves.push_back({std::move(fit_regions({surface.points}, surface)[0]), false, std::nullopt});
  while (leaves.size() < most) {
    double unexplained = 0.0;
    for (Leaf& leaf : leaves) {
      unexplained += leaf.region.unexplained;
      // Splitting gains at most the region's whole cost: one that costs little is not worth a try.
      if (leaf.tried || leaf.region.fit.cost < 0.5 * kPieceCost) continue;
      leaf.split = best_split(leaf.region, surface);
      leaf.tried = true;
    }
    const double allowed = 1.0 - surface.coverage;
    const auto total_gain = [unexplained, allowed](const Leaf& leaf) {
      const double after = std::max(unexplained - leaf.newly_explained(), allowed);
      return leaf.gain() + kShortfallCost * (std::max(unexplained, allowed) - after);
    };
    const auto best = std::max_element(
        leaves.begin(), leaves.end(),
        [&](const Leaf& a, const Leaf& b) { return total_gain(a) < total_gain(b); });
    if (!best->split || total_gain(*best) < 0.0) break;
    Split split = std::move(*best->split);
    *best = {std::move(split.first), false, std::nullopt};
    leaves.push_back({std::move(split.second), false, std::nullopt});
  }
  std::vector<Region> regions;
  for (Leaf& leaf : leaves) regions.push_back(std::move(leaf.region));
  return regions;
}

// From the unit mesh back to the frame and size of the mesh that was given.
Primitive rescaled(Primitive primitive, const UnitMesh& unit) {
  if (auto* box = std::get_if<Box>(&primitive.shape)) box->size *= unit.diagonal;
  if (auto* sphere = std::get_if<Sphere>(&primitive.shape)) sphere->radius *= unit.diagonal;
  if (auto* cylinder = std::get_if<Cylinder>(&primitive.shape)) {
    cylinder->radius *= unit.diagonal;
    cylinder->height *= unit.diagonal;
  }
  if (auto* cone = std::get_if<Cone>(&primitive.shape)) {
    cone->radius_low *= unit.diagonal;
    cone->radius_high *= unit.diagonal;
    cone->height *= unit.diagonal;
  }
  primitive.X_OP.translation() *= unit.diagonal;
  primitive.X_OP = unit.X_OU * primitive.X_OP;
  return along_frame(primitive);
}

// Where a cylinder tapers, the cone about the axis that it will have in the end (aligned).
void make_cones(std::vector<Region>& regions, const Surface& surface,
                const SurfaceMoments& moments) {
  for (Region& region : regions) {
    Primitive& primitive = region.fit.primitive;
    const Primitive found = tapered(aligned(primitive, moments), region.points, surface.tolerance);
    if (std::holds_alternative<Cone>(found.shape)) primitive = found;
  }
}

// The primitives as close to the points as they get, each to those that it is nearest to.
void come_closest(std::vector<Region>& regions, const Surface& surface) {
  std::vector<std::vector<SurfacePoint>> points = points_by_nearest(regions, surface);
  for_each_in_parallel(regions.size(), surface.threads, [&](std::size_t k) {
    surface.cancellation.check();
    if (points[k].empty()) return;
    Region& region = regions[k];
    region.fit.primitive =
        closest_fit(region.fit.primitive, points[k], surface.tolerance, region.shares_axis);
    region.points = std::move(points[k]);
  });
}

// Regions of what coaxial solids leave: all of an object that is nowhere round.
std::vector<Region> fitted_to_rest(const Surface& rest, const DecomposeOptions& options,
                                   const UnitMesh& unit) {
  // A primitive for less of the surface would describe how parts meet, not a part.
  constexpr double kLeastShare = 0.03;
  if (share_of(rest.points.size(), rest) < kLeastShare) return {};
  std::vector<Region> regions = grown(rest, options);
  if (regions.size() > 1) regions = polished(std::move(regions), rest);
  if (rest.points.size() < rest.whole) {
    std::erase_if(regions, [&](const Region& region) {
      return share_of(region.points.size(), rest) - region.unexplained < kLeastShare;
    });
  }
  make_cones(regions, rest, surface_moments(unit.mesh));
  return regions;
}

// Of distances in units of `unit` metres.
SurfaceDistances statistics_of(std::vector<double> distances, double unit) {
  if (distances.empty()) return {};
  return {unit * quantile(distances, 0.5), unit * quantile(distances, 0.95),
          unit * quantile(distances, 1.0)};
}

// How far the points are from the primitives as they were fitted in the end.
void measure_distances(const std::vector<Primitive>& fitted, const Surface& surface, double unit,
                       Decomposition& result) {
  std::vector<double> all;
  std::vector<std::vector<double>> of(fitted.size());
  for (const SurfacePoint& s : surface.points) {
    std::size_t nearest = 0;
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < fitted.size(); ++k) {
      const double d = std::abs(signed_distance(fitted[k], s.p_O));
      if (d >= distance) continue;
      distance = d;
      nearest = k;
    }
    all.push_back(distance);
    of[nearest].push_back(distance);
  }
  result.distances = statistics_of(std::move(all), unit);
  for (std::vector<double>& distances : of) {
    result.distances_of.push_back(statistics_of(std::move(distances), unit));
  }
}

// Each point within tolerance counts for its nearest primitive only, so that shares add up to the
// explained fraction.
Decomposition result_of(const std::vector<Region>& regions, const Surface& surface,
                        const UnitMesh& unit) {
  std::vector<double> share(regions.size(), 0.0);
  const double one = 1.0 / static_cast<double>(surface.points.size());
  for (const SurfacePoint& s : surface.points) {
    double nearest = surface.tolerance;
    std::optional<std::size_t> owner;
    for (std::size_t k = 0; k < regions.size(); ++k) {
      const double d = std::abs(signed_distance(regions[k].fit.primitive, s.p_O));
      if (d <= nearest) {
        nearest = d;
        owner = k;
      }
    }
    if (owner) share[*owner] += one;
  }
  std::vector<std::size_t> order(regions.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return share[a] > share[b]; });
  Decomposition result;
  std::vector<Primitive> fitted;
  const SurfaceMoments moments = surface_moments(unit.mesh);
  for (const std::size_t k : order) {
    const Primitive primitive = aligned(regions[k].fit.primitive, moments);
    fitted.push_back(on_vertices(primitive, regions[k].points, unit.mesh));
    result.primitives.push_back(rescaled(fitted.back(), unit));
    result.share.push_back(share[k]);
    result.explained += share[k];
  }
  result.tolerance = surface.tolerance * unit.diagonal;
  measure_distances(fitted, surface, unit.diagonal, result);
  return result;
}

// Whether one primitive describes the object: a box is a box although its middle could be a
// cylinder with few gaps.
bool is_enough(const Region& region, const Surface& surface) {
  constexpr double kGoodFit = 0.08;
  return region.unexplained <= 1.0 - surface.coverage && region.fit.cost <= kGoodFit;
}

std::vector<Region> fitted_in_parts(const Surface& surface, const DecomposeOptions& options,
                                    const UnitMesh& unit) {
  Surface rest = surface;
  std::vector<Region> regions = take_coaxial_solids(rest);
  for (Region& region : fitted_to_rest(rest, options, unit)) regions.push_back(std::move(region));
  return regions;
}

}  // namespace

double relative_tolerance(const TriangleMesh& mesh, double length) {
  require_valid_indices(mesh, "mesh");
  const double diagonal = own_frame(mesh).diagonal;
  require(length > 0.0 && length <= diagonal,
          {.field = "tolerance",
           .problem = formatted("must be above 0 and at most the object's diagonal, %.4g mm",
                                1000.0 * diagonal),
           .value = formatted("%.4g mm", 1000.0 * length)});
  // Rounding must not make a diagonal more than a diagonal.
  return std::min(length / diagonal, 1.0);
}

Decomposition decompose(const TriangleMesh& mesh, const DecomposeOptions& options,
                        const RunContext& context) {
  context.cancellation.check();
  check(mesh, options);
  const UnitMesh unit = unit_mesh(mesh);
  const auto [smooth, exact] = surfaces_of(unit.mesh, options, context);
  std::vector<Region> regions = fit_regions({smooth.points}, smooth);
  if (!is_enough(regions.front(), smooth)) regions = fitted_in_parts(smooth, options, unit);
  regions = reduced(std::move(regions), smooth, static_cast<std::size_t>(options.max_primitives));
  come_closest(regions, exact);
  return result_of(regions, exact, unit);
}

}  // namespace prehend
