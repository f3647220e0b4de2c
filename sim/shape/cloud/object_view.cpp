#include "sim/shape/cloud/object_view.h"

#include <algorithm>
#include <cmath>

#include "sim/shape/cloud/distance_transform.h"

namespace prehend {
namespace {

// Pixels without reading are taken for the thing's, perhaps, as near to it as this: surfaces at
// grazing angles give no readings [pixels].
constexpr float kGrazingBorder = 2.5F;
constexpr float kFarEdge = 1e4F;

// The mean over windows of 5 x 5 pixels.
std::vector<float> smoothed(const std::vector<float>& values, int width, int height) {
  std::vector<float> rows(values.size());
  std::vector<float> result(values.size());
  const auto at = [&](int x, int y) {
    return index(std::clamp(y, 0, height - 1)) * index(width) + index(std::clamp(x, 0, width - 1));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int k = -2; k <= 2; ++k) rows[at(x, y)] += 0.2F * values[at(x + k, y)];
    }
  }
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int k = -2; k <= 2; ++k) result[at(x, y)] += 0.2F * rows[at(x, y + k)];
    }
  }
  return result;
}

}  // namespace

void find_edges(ObjectView& view) {
  const std::array<int, 3> size = {view.width, view.height, 1};
  const std::size_t count = view.kind.size();
  std::vector<char> from(count);
  for (std::size_t i = 0; i < count; ++i) from[i] = view.kind[i] == PixelKind::thing ? 1 : 0;
  const std::vector<float> to_thing = distance_transform(from, size, kFarEdge);
  for (std::size_t i = 0; i < count; ++i) {
    if (view.kind[i] != PixelKind::thing && view.depth[i] <= 0.0F) {
      view.kind[i] = to_thing[i] <= kGrazingBorder ? PixelKind::hidden : PixelKind::beyond;
    }
    from[i] = view.kind[i] != PixelKind::beyond ? 1 : 0;
  }
  view.to_edge = distance_transform(from, size, kFarEdge);
  for (char& is : from) is = is != 0 ? 0 : 1;
  const std::vector<float> inside = distance_transform(from, size, kFarEdge);
  // The edge is half-way between the two pixels. Single pixels of it are noise.
  std::vector<float> edge(count);
  for (std::size_t i = 0; i < count; ++i) {
    edge[i] = from[i] != 0 ? view.to_edge[i] - 0.5F : 0.5F - inside[i];
  }
  edge = smoothed(edge, view.width, view.height);
  for (std::size_t i = 0; i < count; ++i) {
    view.to_edge[i] = std::max(0.0F, from[i] != 0 ? edge[i] : -edge[i]);
  }
}

PointSample sample(const ObjectView& view, const Eigen::Vector3f& p_P, float far) {
  const Eigen::Vector3f p_C = view.X_CP * p_P;
  const float z = p_C.z();
  if (z <= 1e-3F) return {.distance = -far};
  const auto fx = static_cast<float>(view.camera.fx);
  const auto fy = static_cast<float>(view.camera.fy);
  const float x = fx * p_C.x() / z + static_cast<float>(view.camera.cx);
  const float y = fy * p_C.y() / z + static_cast<float>(view.camera.cy);
  const float limit = 1e6F;
  const auto u = static_cast<int>(std::floor(std::clamp(x, -limit, limit) + 0.5F));
  const auto v = static_cast<int>(std::floor(std::clamp(y, -limit, limit) + 0.5F));
  // Beside the picture nothing is known.
  if (u < 0 || v < 0 || u >= view.camera.width || v >= view.camera.height) {
    return {.distance = -far};
  }
  if (!view.contains(u, v)) return {.distance = far};
  const std::size_t i = view.at(u, v);
  const float edge = view.to_edge[i] * z / std::min(fx, fy);
  switch (view.kind[i]) {
    case PixelKind::hidden:
      if (view.depth[i] > 0.0F && z < view.depth[i]) {
        return {.distance = std::min(view.depth[i] - z, far)};
      }
      return {.distance = -std::min(edge, far)};
    case PixelKind::thing: {
      const LocalPlane& surface = view.surface[i];
      const float distance = surface.distance(p_C);
      return {.distance = std::clamp(distance, -std::min(std::max(edge, 0.0F), far), far),
              .surface = &surface,
              .width = edge};
    }
    case PixelKind::beyond:
      break;
  }
  if (view.depth[i] <= 0.0F) return {.distance = std::min(edge, far)};
  const float before = view.depth[i] - z;
  // Behind what stands behind the thing nothing is known.
  if (before <= 0.0F) return {.distance = -far};
  return {.distance = std::min({before, edge, far})};
}

float allowed_distance(const std::vector<ObjectView>& views, const Eigen::Vector3f& p_P,
                       float far) {
  float most = -far;
  for (const ObjectView& view : views) most = std::max(most, sample(view, p_P, far).distance);
  return most;
}

std::vector<SeenPoint> seen_points(const std::vector<ObjectView>& views) {
  std::vector<SeenPoint> points;
  for (std::size_t k = 0; k < views.size(); ++k) {
    const ObjectView& view = views[k];
    const Eigen::Isometry3d X_PC = view.X_CP.inverse().cast<double>();
    for (std::size_t i = 0; i < view.kind.size(); ++i) {
      if (view.kind[i] != PixelKind::thing) continue;
      const int u = view.left + static_cast<int>(i) % view.width;
      const int v = view.top + static_cast<int>(i) / view.width;
      const LocalPlane& surface = view.surface[i];
      const Eigen::Vector3f ray = pixel_ray(view.camera, u, v);
      const Eigen::Vector3f p_C = ray / std::max(surface.inverse.dot(ray), 1e-6F);
      points.push_back({X_PC * p_C.cast<double>(),
                        (X_PC.linear() * surface.normal().cast<double>()).normalized(),
                        view.to_edge[i] * static_cast<double>(p_C.z()) /
                            std::min(view.camera.fx, view.camera.fy),
                        static_cast<int>(k), i});
    }
  }
  return points;
}

}  // namespace prehend
