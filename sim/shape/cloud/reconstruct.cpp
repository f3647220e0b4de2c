#include "sim/shape/cloud/reconstruct.h"

#include <algorithm>
#include <cmath>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/require_settings.h"
#include "sim/shape/cloud/complete_shape.h"
#include "sim/shape/cloud/cut_out.h"
#include "sim/shape/cloud/grid_parts.h"
#include "sim/shape/cloud/other_shapes.h"
#include "sim/shape/cloud/prepare_views.h"

namespace prehend {
namespace {

constexpr double kLargestThing = 0.8;  // larger clusters are walls and the like [m]
constexpr double kSmallestThing = 0.004;
constexpr int kMostThings = 50;

// Whether a camera saw the surface at each triangle, near enough and from its front.
std::vector<char> seen_triangles(const TriangleMesh& mesh, const std::vector<ObjectView>& views,
                                 float tolerance) {
  std::vector<char> seen(mesh.triangles.size(), 0);
  for (std::size_t t = 0; t < seen.size(); ++t) {
    const Corners corners = corners_of(mesh, static_cast<int>(t));
    const Eigen::Vector3f middle = ((corners[0] + corners[1] + corners[2]) / 3.0).cast<float>();
    const Eigen::Vector3f normal = doubled_area_vector(mesh, t).normalized().cast<float>();
    for (const ObjectView& view : views) {
      const PointSample here = sample(view, middle, 1.0F);
      if (here.surface == nullptr) continue;
      const float off = here.surface->distance(view.X_CP * middle);
      if (std::abs(off) > tolerance) continue;
      if ((view.X_CP.linear() * normal).dot(here.surface->normal()) > 0.5F) seen[t] = 1;
    }
  }
  return seen;
}

SeenObject make_object(const PreparedViews& prepared, const std::vector<ObjectView>& views,
                       const std::vector<SeenPoint>& points, const ReconstructOptions& options,
                       const RunContext& context) {
  SymmetryOptions judged;
  judged.upright = prepared.plane.has_value();
  judged.tolerance = static_cast<float>(0.003 + 0.5 * prepared.largest_noise);
  FoundSymmetry symmetry;
  if (options.use_symmetry) symmetry = find_symmetry(views, points, judged);
  context.cancellation.check();
  CompletionOptions completion;
  completion.voxel = options.voxel;
  completion.on_support = judged.upright;
  DistanceGrid likely = complete_shape(views, points, symmetry, judged, completion, context);
  std::vector<Vector3> seen;
  for (const SeenPoint& point : points) seen.push_back(point.p_P);
  keep_seen_parts(likely, seen);
  OtherShapes others = other_shapes(likely, views, points, symmetry, judged.upright, context);
  SeenObject object;
  object.readings = points.size();
  object.symmetry = symmetry.kind;
  const Pose X_WP = prepared.X_PW.inverse();
  make_well_composed(likely);
  const TriangleMesh mesh = surface_net(likely);
  object.seen = seen_triangles(mesh, views, static_cast<float>(likely.edge));
  object.mesh = transformed(mesh, X_WP);
  const auto made = [&](DistanceGrid& grid) {
    keep_seen_parts(grid, seen);
    make_well_composed(grid);
    return transformed(surface_net(grid), X_WP);
  };
  object.thin = made(others.thin);
  object.thick = made(others.thick);
  return object;
}

double extent_of(const std::vector<SeenPoint>& points) {
  Bounds box;
  for (const SeenPoint& point : points) {
    box.lower = box.lower.cwiseMin(point.p_P);
    box.upper = box.upper.cwiseMax(point.p_P);
  }
  return points.empty() ? 0.0 : box.diagonal();
}

std::string millimetres(double metres) {
  return std::to_string(static_cast<int>(std::lround(1e3 * metres))) + " mm";
}

}  // namespace

Reconstruction reconstruct(const std::vector<DepthView>& views, const ReconstructOptions& options,
                           const RunContext& context) {
  require_settings(options);
  const PreparedViews prepared = prepare_views(views, options, context);
  Reconstruction result;
  if (prepared.plane) {
    result.plane = prepared.plane->plane;
  } else if (options.find_plane) {
    result.notes.emplace_back("no support was found: what is below the things is not known");
  }
  if (prepared.left_out > 0) {
    result.notes.push_back(std::to_string(prepared.left_out) + " clusters of fewer readings than " +
                           std::to_string(options.min_readings) + " were left out");
  }
  if (prepared.count > kMostThings) {
    result.notes.push_back("of " + std::to_string(prepared.count) + " clusters, those after the " +
                           std::to_string(kMostThings) + " largest were left out");
  }
  for (int k = 0; k < std::min(prepared.count, kMostThings); ++k) {
    const std::vector<ObjectView> cuts = cut_out(prepared, k, options.drop_outliers, context);
    const std::vector<SeenPoint> points = seen_points(cuts);
    const double extent = extent_of(points);
    if (points.size() < index(std::max(options.min_readings, 1)) || extent < kSmallestThing) {
      continue;
    }
    if (extent > kLargestThing) {
      result.notes.push_back("a cluster " + millimetres(extent) + " across was left out");
      continue;
    }
    SeenObject object = make_object(prepared, cuts, points, options, context);
    if (!object.mesh.empty()) result.objects.push_back(std::move(object));
  }
  require(!result.objects.empty(),
          {.field = "views", .problem = "there is no object in what was seen"});
  std::stable_sort(
      result.objects.begin(), result.objects.end(),
      [](const SeenObject& a, const SeenObject& b) { return a.readings > b.readings; });
  return result;
}

}  // namespace prehend
