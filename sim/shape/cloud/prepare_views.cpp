#include "sim/shape/cloud/prepare_views.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/base/index.h"
#include "sim/base/input_error.h"
#include "sim/base/number_text.h"
#include "sim/shape/cloud/cluster_readings.h"
#include "sim/shape/cloud/floating_clusters.h"
#include "sim/shape/cloud/seen_surface.h"

namespace prehend {
namespace {

constexpr std::size_t kMostReadings = 25'000'000;
constexpr double kFarthest = 20.0;  // [m]
constexpr double kHighest = 1.0;    // above the support [m]

double median_depth(const std::vector<DepthView>& views) {
  std::vector<float> depths;
  for (const DepthView& view : views) {
    const std::size_t stride = std::max<std::size_t>(1, view.depth.size() / 10000);
    for (std::size_t i = 0; i < view.depth.size(); i += stride) {
      if (view.depth[i] > 0.0F) depths.push_back(view.depth[i]);
    }
  }
  if (depths.empty()) return 0.0;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  return static_cast<double>(*middle);
}

void check_camera(const DepthView& view, const std::string& name) {
  const DepthCamera& camera = view.camera;
  require(camera.width > 0 && camera.height > 0 &&
              view.depth.size() == index(camera.width) * index(camera.height),
          {.field = name + ".depth",
           .problem = "must have a reading for each of width x height pixels",
           .value = std::to_string(view.depth.size())});
  require(
      std::isfinite(camera.fx) && std::isfinite(camera.fy) && camera.fx > 0.0 && camera.fy > 0.0,
      {.field = name + ".camera.fx", .problem = "focal lengths must be positive"});
  require(std::isfinite(camera.cx) && std::isfinite(camera.cy),
          {.field = name + ".camera.cx", .problem = "must be finite"});
  require(camera.X_WC.matrix().allFinite(),
          {.field = name + ".camera.X_WC", .problem = "must be finite"});
}

// The views with readings that are not finite or not in front of the camera taken out.
std::vector<DepthView> checked(const std::vector<DepthView>& views) {
  require(!views.empty(), {.field = "views", .problem = "there is none"});
  std::size_t total = 0;
  for (std::size_t k = 0; k < views.size(); ++k) {
    check_camera(views[k], "views[" + std::to_string(k) + "]");
    total += views[k].depth.size();
  }
  require(total <= kMostReadings,
          {.field = "views",
           .problem = "have more pixels than the 25 million that are read; give fewer views or "
                      "smaller pictures",
           .value = std::to_string(total)});
  std::vector<DepthView> kept = views;
  std::size_t readings = 0;
  for (DepthView& view : kept) {
    for (float& depth : view.depth) {
      if (!(std::isfinite(depth) && depth > 0.0F)) depth = 0.0F;
      readings += depth > 0.0F ? 1 : 0;
    }
  }
  require(readings > 0, {.field = "views", .problem = "there is no reading in them"});
  const double middle = median_depth(kept);
  require(middle <= kFarthest,
          {.field = "views",
           .problem = "half of the readings are farther away than 20 m: are they millimetres?",
           .value = number_text(middle) + " m"});
  return kept;
}

Pose frame_of(const FoundPlane& found) {
  const Vector3& z = found.plane.normal_W;
  Vector3 x = Vector3::UnitX() - z.x() * z;
  if (x.norm() < 0.1) x = Vector3::UnitY() - z.y() * z;
  Matrix3 axes;
  axes << x.normalized(), z.cross(x.normalized()), z;
  return pose_from(axes, found.point_W);
}

// Without a support, up is up in the first picture.
Pose frame_without_support(const DepthView& view) {
  Matrix3 axes;
  const Matrix3 R_WC = view.camera.X_WC.linear();
  axes << R_WC.col(0), R_WC.col(2), -R_WC.col(1);
  return pose_from(axes, view.camera.X_WC.translation());
}

void find_plane(PreparedViews& prepared, const ReconstructOptions& options) {
  for (const DepthView& view : prepared.views) prepared.noise.push_back(noise_of(view));
  prepared.largest_noise = *std::max_element(prepared.noise.begin(), prepared.noise.end());
  prepared.X_PW = frame_without_support(prepared.views.front()).inverse();
  if (!options.find_plane) return;
  const PlaneSearch search = find_support(prepared.views, prepared.largest_noise, options.seed);
  require(!search.plane_only, {.field = "views", .problem = "show a plane and nothing on it"});
  prepared.plane = search.found;
  if (search.found) prepared.X_PW = frame_of(*search.found).inverse();
}

// Whether a reading at p_P, of a reading W, may be a thing's.
bool may_be_thing(const PreparedViews& prepared, const Vector3& p_W, double least_height) {
  if (!prepared.plane) return true;
  const double height = (prepared.X_PW * p_W).z();
  return height > least_height && height < kHighest &&
         above_outline(prepared.plane->plane, p_W, 0.02);
}

template <typename Visit>
void for_each_reading(const DepthView& view, const Visit& visit) {
  for (int v = 0; v < view.camera.height; ++v) {
    for (int u = 0; u < view.camera.width; ++u) {
      const std::size_t i = index(v) * index(view.camera.width) + index(u);
      if (view.depth[i] <= 0.0F) continue;
      visit(i, u, v, Vector3(view.camera.X_WC * reading_at(view, u, v).cast<double>()));
    }
  }
}

// The height above the support from which on a reading may be a thing's [m]: so much that noise of
// the support's own readings next to never reaches it. Else they join things that stand apart, the
// more so the more views there are. Noise grows with the square of the depth, as that of
// structured light and stereo cameras does (Nguyen et al. 2012), from where half of the readings
// are.
double least_height(double noise, double depth, double median) {
  const double farther = std::max(1.0, depth / median);
  return std::max(0.003, 3.0 * noise * farther * farther);
}

void find_clusters(PreparedViews& prepared, const ReconstructOptions& options) {
  double pitch = 0.0;
  std::vector<double> medians;
  for (const DepthView& view : prepared.views) {
    medians.push_back(median_depth({view}));
    pitch = std::max(pitch, medians.back() / std::min(view.camera.fx, view.camera.fy));
  }
  ReadingClusters clusters(std::max({options.gap / 1.5, 4.0 * pitch, options.voxel}));
  std::vector<std::vector<char>> taken;
  for (std::size_t k = 0; k < prepared.views.size(); ++k) {
    const DepthView& view = prepared.views[k];
    taken.emplace_back(view.depth.size(), 0);
    for_each_reading(view, [&](std::size_t i, int, int, const Vector3& p_W) {
      const double depth = static_cast<double>(view.depth[i]);
      if (!may_be_thing(prepared, p_W, least_height(prepared.noise[k], depth, medians[k]))) return;
      clusters.add(p_W);
      taken.back()[i] = 1;
    });
  }
  clusters.join(index(std::max(options.min_readings, 1)));
  prepared.count = clusters.count();
  prepared.left_out = clusters.left_out();
  for (std::size_t k = 0; k < prepared.views.size(); ++k) {
    prepared.cluster.emplace_back(taken[k].size(), -1);
    for_each_reading(prepared.views[k], [&](std::size_t i, int, int, const Vector3& p_W) {
      if (taken[k][i] != 0) prepared.cluster[k][i] = clusters.cluster_at(p_W);
    });
  }
}

}  // namespace

PreparedViews prepare_views(const std::vector<DepthView>& views, const ReconstructOptions& options,
                            const RunContext& context) {
  PreparedViews prepared;
  prepared.views = checked(views);
  context.cancellation.check();
  find_plane(prepared, options);
  context.cancellation.check();
  find_clusters(prepared, options);
  if (prepared.plane) join_floating_clusters(prepared);
  return prepared;
}

}  // namespace prehend
