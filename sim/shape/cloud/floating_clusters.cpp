#include "sim/shape/cloud/floating_clusters.h"

#include <algorithm>
#include <map>

#include "sim/base/index.h"
#include "sim/shape/cloud/seen_surface.h"

namespace prehend {
namespace {

constexpr int kStep = 2;               // to the pixel that is compared with [pixels]
constexpr float kEdgeDepth = 0.01F;    // depths of an edge [m]
constexpr double kFloats = 0.015;      // lowest reading above the support [m]
constexpr double kMostCovered = 0.05;  // of the edges, where something stands before it
constexpr double kLeastBefore = 0.03;  // of the edges, before the cluster that it rests on

// What the pictures show of a cluster.
struct Outlook {
  double lowest = 1e9;  // above the support [m]
  Bounds plan;
  int edges = 0;
  int covered = 0;            // of the edges, behind something
  std::map<int, int> before;  // of the edges, before other clusters
};

std::vector<Outlook> outlooks_of(const PreparedViews& prepared) {
  std::vector<Outlook> outlooks(index(prepared.count));
  for (std::size_t k = 0; k < prepared.views.size(); ++k) {
    const DepthView& view = prepared.views[k];
    const std::vector<int>& cluster = prepared.cluster[k];
    const int width = view.camera.width;
    const Pose X_PC = prepared.X_PW * view.camera.X_WC;
    for (std::size_t i = 0; i < cluster.size(); ++i) {
      if (cluster[i] < 0) continue;
      const auto u = static_cast<int>(i % index(width));
      const auto v = static_cast<int>(i / index(width));
      Outlook& outlook = outlooks[index(cluster[i])];
      const Vector3 p_P = X_PC * reading_at(view, u, v).cast<double>();
      outlook.lowest = std::min(outlook.lowest, p_P.z());
      outlook.plan.lower = outlook.plan.lower.cwiseMin(p_P);
      outlook.plan.upper = outlook.plan.upper.cwiseMax(p_P);
      for (int side = 0; side < 4; ++side) {
        const int x = u + (side == 0 ? kStep : (side == 1 ? -kStep : 0));
        const int y = v + (side == 2 ? kStep : (side == 3 ? -kStep : 0));
        if (x < 0 || y < 0 || x >= width || y >= view.camera.height) continue;
        const std::size_t j = index(y) * index(width) + index(x);
        if (cluster[j] == cluster[i] || view.depth[j] <= 0.0F) continue;
        ++outlook.edges;
        if (view.depth[j] < view.depth[i] - kEdgeDepth) ++outlook.covered;
        if (view.depth[j] > view.depth[i] + kEdgeDepth && cluster[j] >= 0)
          ++outlook.before[cluster[j]];
      }
    }
  }
  return outlooks;
}

bool above_each_other(const Bounds& a, const Bounds& b) {
  return a.lower.x() <= b.upper.x() && b.lower.x() <= a.upper.x() && a.lower.y() <= b.upper.y() &&
         b.lower.y() <= a.upper.y();
}

// What a cluster rests on; -1: on the support, or nobody knows.
int rests_on(const Outlook& outlook, const std::vector<Outlook>& all) {
  if (outlook.lowest < kFloats || outlook.covered > kMostCovered * outlook.edges) return -1;
  int best = -1;
  int most = static_cast<int>(kLeastBefore * outlook.edges);
  for (const auto& [other, edges] : outlook.before) {
    if (edges <= most || !above_each_other(outlook.plan, all[index(other)].plan)) continue;
    most = edges;
    best = other;
  }
  return best;
}

}  // namespace

void join_floating_clusters(PreparedViews& prepared) {
  const std::vector<Outlook> outlooks = outlooks_of(prepared);
  std::vector<int> number(outlooks.size());
  bool joined = false;
  for (std::size_t c = 0; c < number.size(); ++c) {
    const int below = rests_on(outlooks[c], outlooks);
    number[c] = below >= 0 ? below : static_cast<int>(c);
    joined = joined || below >= 0;
  }
  if (!joined) return;
  for (std::vector<int>& cluster : prepared.cluster) {
    for (int& c : cluster) {
      // A tower of three: no thing rests on one that rests on it.
      for (int k = 0; k < 3 && c >= 0; ++k) c = number[index(c)];
    }
  }
}

}  // namespace prehend
