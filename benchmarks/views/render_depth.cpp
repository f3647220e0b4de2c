#include "benchmarks/views/render_depth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/index.h"

namespace prehend::bench {
namespace {

constexpr double kSteepest = 80.0 * std::numbers::pi / 180.0;

struct PixelHit {
  double depth = 0.0;  // 0: nothing
  double cosine = 1.0;
};

PixelHit look(const DepthCamera& camera, const std::vector<ShownThing>& things, double half_table,
              double u, double v) {
  const Vector3 ray_C((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1.0);
  const double length = ray_C.norm();
  const Vector3 from = camera.X_WC.translation();
  const Vector3 along = camera.X_WC.linear() * ray_C / length;
  double nearest = 10.0;
  PixelHit seen;
  if (half_table > 0.0 && along.z() < 0.0) {
    const double way = -from.z() / along.z();
    const Vector3 p = from + way * along;
    if (std::abs(p.x()) <= half_table && std::abs(p.y()) <= half_table && way < nearest) {
      nearest = way;
      seen = {way / length, -along.z()};
    }
  }
  for (const ShownThing& thing : things) {
    const Pose X_OW = thing.X_WO.inverse();
    const RayHit hit = first_hit(*thing.mesh, X_OW * from, X_OW.linear() * along, nearest);
    if (hit.triangle < 0 || hit.distance >= nearest) continue;
    nearest = hit.distance;
    const Vector3 normal =
        thing.X_WO.linear() * doubled_area_vector(thing.mesh->mesh(), index(hit.triangle));
    seen = {hit.distance / length, std::abs(normal.normalized().dot(along))};
  }
  return seen;
}

}  // namespace

DepthView render_depth(const DepthCamera& camera, const std::vector<ShownThing>& things,
                       double half_table, const CameraNoise& noise, Random& random) {
  DepthView view{camera, std::vector<float>(index(camera.width) * index(camera.height), 0.0F)};
  std::vector<PixelHit> exact;
  exact.reserve(view.depth.size());
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) exact.push_back(look(camera, things, half_table, u, v));
  }
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const std::size_t i = index(v) * index(camera.width) + index(u);
      if (!noise.noisy) {
        view.depth[i] = static_cast<float>(exact[i].depth);
        continue;
      }
      const int du = random.integer(-1, 1);
      const int dv = random.integer(-1, 1);
      const double normal = random.normal();
      const int x = std::clamp(u + du, 0, camera.width - 1);
      const int y = std::clamp(v + dv, 0, camera.height - 1);
      const PixelHit& beside = exact[index(y) * index(camera.width) + index(x)];
      const bool edge = std::abs(beside.depth - exact[i].depth) > 0.01;
      const PixelHit& seen = edge ? beside : exact[i];
      if (seen.depth <= 0.0 || seen.cosine < std::cos(kSteepest)) continue;
      const double off = seen.depth - 0.4;
      const double deviation = noise.factor * (0.0012 + 0.0019 * off * off);
      const double depth = seen.depth + deviation * normal;
      view.depth[i] = static_cast<float>(noise.quantum * std::round(depth / noise.quantum));
    }
  }
  return view;
}

}  // namespace prehend::bench
