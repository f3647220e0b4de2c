#include "sim/shape/cloud/other_shapes.h"

#include <algorithm>
#include <cmath>

#include "sim/base/parallel/parallel.h"
#include "sim/shape/cloud/distance_transform.h"

namespace prehend {
namespace {

// By how much the unseen surface may be elsewhere [m], for each kind of symmetry; without one, by a
// share of the thing's smallest extent.
double uncertainty(Symmetry kind, const Vector3& extent) {
  switch (kind) {
    case Symmetry::revolution:
      return 0.003;
    case Symmetry::two_mirrors:
      return 0.004;
    case Symmetry::mirror:
      return 0.006;
    case Symmetry::none:
      break;
  }
  return std::clamp(0.2 * extent.minCoeff(), 0.005, 0.015);
}

// Distances from the surface of the grid, to the accuracy of a cell.
std::vector<float> redistanced(const DistanceGrid& grid) {
  std::vector<char> from(grid.value.size());
  for (std::size_t i = 0; i < from.size(); ++i) from[i] = grid.value[i] < 0.0F ? 1 : 0;
  std::vector<float> outside = distance_transform(from, grid.size, 1e4F);
  for (char& is : from) is = is != 0 ? 0 : 1;
  const std::vector<float> inside = distance_transform(from, grid.size, 1e4F);
  const auto edge = static_cast<float>(grid.edge);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const float rough = from[i] != 0 ? edge * (outside[i] - 0.5F) : edge * (0.5F - inside[i]);
    // Near the surface, what was measured is better.
    outside[i] = std::abs(grid.value[i]) < edge ? grid.value[i] : rough;
  }
  return outside;
}

std::vector<float> distance_to_seen(const DistanceGrid& grid,
                                    const std::vector<SeenPoint>& points) {
  std::vector<char> from(grid.value.size(), 0);
  for (const SeenPoint& point : points) {
    const Vector3 at = ((point.p_P - grid.lower) / grid.edge).array().round();
    std::array<int, 3> cell{};
    bool within = true;
    for (std::size_t k = 0; k < 3; ++k) {
      cell[k] = static_cast<int>(at[static_cast<Eigen::Index>(k)]);
      within = within && cell[k] >= 0 && cell[k] < grid.size[k];
    }
    if (within) from[grid.at(cell[0], cell[1], cell[2])] = 1;
  }
  std::vector<float> distance = distance_transform(from, grid.size, 1e4F);
  for (float& d : distance) d *= static_cast<float>(grid.edge);
  return distance;
}

}  // namespace

OtherShapes other_shapes(const DistanceGrid& likely, const std::vector<ObjectView>& views,
                         const std::vector<SeenPoint>& points, const FoundSymmetry& symmetry,
                         bool on_support, const RunContext& context) {
  Bounds box;
  for (const SeenPoint& point : points) {
    box.lower = box.lower.cwiseMin(point.p_P);
    box.upper = box.upper.cwiseMax(point.p_P);
  }
  const auto most = static_cast<float>(uncertainty(symmetry.kind, box.size()));
  const std::vector<float> distance = redistanced(likely);
  const std::vector<float> to_seen = distance_to_seen(likely, points);
  OtherShapes others{likely, likely};
  const auto edge = static_cast<float>(likely.edge);
  for_each_in_parallel(index(likely.size[2]), context.threads, [&](std::size_t layer) {
    context.cancellation.check();
    const auto z = static_cast<int>(layer);
    for (int y = 0; y < likely.size[1]; ++y) {
      for (int x = 0; x < likely.size[0]; ++x) {
        const std::size_t i = likely.at(x, y, z);
        const float moved = std::clamp(0.5F * (to_seen[i] - 2.0F * edge), 0.0F, most);
        if (moved <= 0.0F || std::abs(distance[i]) > most + edge) continue;
        others.thin.value[i] = distance[i] + moved;
        const Eigen::Vector3f p_P = likely.corner(x, y, z).cast<float>();
        float allowed = allowed_distance(views, p_P, 4.0F * edge) - 0.3F * edge;
        if (on_support) allowed = std::max(allowed, -p_P.z());
        others.thick.value[i] = std::max(distance[i] - moved, allowed);
      }
    }
  });
  return others;
}

}  // namespace prehend
