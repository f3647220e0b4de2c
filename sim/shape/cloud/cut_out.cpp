#include "sim/shape/cloud/cut_out.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/base/disjoint_sets.h"
#include "sim/base/index.h"
#include "sim/base/parallel/parallel.h"

namespace prehend {
namespace {

constexpr int kBorder = 12;  // of a cutout around the thing [pixels]
constexpr int kFoot = 4;     // readings near the support are looked at so near a thing [pixels]
constexpr double kLeastHeight = 2e-3;   // of smoothed readings above the support [m]
constexpr float kSameSurface = 0.015F;  // of two pixels side by side, difference of depths [m]
constexpr int kSpeck = 12;              // a patch of fewer pixels is none of the thing
constexpr float kGrazing = 0.09F;  // cosine of the angle at which surfaces are not to be trusted

// The rectangle of pixels around a cluster, and the median of its depths.
struct CutFrame {
  int left = std::numeric_limits<int>::max();
  int top = std::numeric_limits<int>::max();
  int right = -1;
  int bottom = -1;
  float depth = 0.0F;

  bool empty() const { return right < left; }
};

CutFrame cut_frame(const DepthView& view, const std::vector<int>& cluster, int wanted) {
  CutFrame frame;
  std::vector<float> depths;
  for (std::size_t i = 0; i < cluster.size(); ++i) {
    if (cluster[i] != wanted) continue;
    const auto u = static_cast<int>(i % index(view.camera.width));
    const auto v = static_cast<int>(i / index(view.camera.width));
    frame.left = std::min(frame.left, u);
    frame.right = std::max(frame.right, u);
    frame.top = std::min(frame.top, v);
    frame.bottom = std::max(frame.bottom, v);
    depths.push_back(view.depth[i]);
  }
  if (depths.empty()) return frame;
  const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
  std::nth_element(depths.begin(), middle, depths.end());
  frame.depth = *middle;
  frame.left = std::max(0, frame.left - kBorder);
  frame.top = std::max(0, frame.top - kBorder);
  frame.right = std::min(view.camera.width - 1, frame.right + kBorder);
  frame.bottom = std::min(view.camera.height - 1, frame.bottom + kBorder);
  return frame;
}

// Decides on each pixel of a cutout.
class Cutter {
 public:
  Cutter(const PreparedViews& prepared, std::size_t k, int cluster, bool drop)
      : view_(prepared.views[k]),
        cluster_(prepared.cluster[k]),
        wanted_(cluster),
        drop_(drop),
        on_support_(prepared.plane.has_value()),
        X_PC_(prepared.X_PW * prepared.views[k].camera.X_WC),
        fitter_(prepared.views[k], prepared.noise[k]) {}

  void decide(ObjectView& cut, const CutFrame& frame, int u, int v) const {
    const std::size_t i = pixel(u, v);
    const std::size_t at = cut.at(u, v);
    cut.depth[at] = view_.depth[i];
    if (view_.depth[i] <= 0.0F) return;
    if (cluster_[i] != wanted_) {
      if (cluster_[i] >= 0) {
        // Another thing: in front of this one, or behind it.
        if (view_.depth[i] < frame.depth) cut.kind[at] = PixelKind::hidden;
        return;
      }
      if (!on_support_ || !near_thing(u, v)) return;
    }
    LocalPlane surface = fitter_.at(u, v);
    const Eigen::Vector3f ray = pixel_ray(view_.camera, u, v);
    const bool grazing = surface.exists() && -surface.normal().dot(ray.normalized()) < kGrazing;
    if (!surface.exists() || grazing) {
      if (cluster_[i] != wanted_) return;
      if (drop_) {
        cut.depth[at] = 0.0F;
        return;
      }
      surface.inverse = {0.0F, 0.0F, 1.0F / view_.depth[i]};
    }
    if (on_support_) {
      const Vector3 p_C = (ray / surface.inverse.dot(ray)).cast<double>();
      if ((X_PC_ * p_C).z() < kLeastHeight) return;
    }
    cut.kind[at] = PixelKind::thing;
    cut.surface[at] = surface;
  }

 private:
  std::size_t pixel(int u, int v) const { return index(v) * index(view_.camera.width) + index(u); }

  bool near_thing(int u, int v) const {
    for (int y = std::max(0, v - kFoot); y <= std::min(view_.camera.height - 1, v + kFoot); ++y) {
      for (int x = std::max(0, u - kFoot); x <= std::min(view_.camera.width - 1, u + kFoot); ++x) {
        if (cluster_[pixel(x, y)] == wanted_) return true;
      }
    }
    return false;
  }

  const DepthView& view_;
  const std::vector<int>& cluster_;
  int wanted_;
  bool drop_;
  bool on_support_;
  Pose X_PC_;
  PlaneFitter fitter_;
};

// Takes pixels out of the thing that belong to patches of few pixels: mixed readings at the edge of
// the thing, between it and what is far behind it, look like a surface here and there.
void drop_specks(ObjectView& cut) {
  DisjointSets patches(cut.kind.size());
  const auto join = [&](std::size_t a, std::size_t b) {
    if (cut.kind[a] != PixelKind::thing || cut.kind[b] != PixelKind::thing) return;
    if (std::abs(cut.depth[a] - cut.depth[b]) < kSameSurface) patches.merge(a, b);
  };
  const std::size_t width = index(cut.width);
  for (std::size_t i = 0; i < cut.kind.size(); ++i) {
    const std::size_t u = i % width;
    const bool below = i + width < cut.kind.size();
    if (u + 1 < width) join(i, i + 1);
    if (below) join(i, i + width);
    if (below && u + 1 < width) join(i, i + width + 1);
    if (below && u > 0) join(i, i + width - 1);
  }
  std::vector<int> pixels(cut.kind.size(), 0);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (cut.kind[i] == PixelKind::thing) ++pixels[patches.find(i)];
  }
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (cut.kind[i] != PixelKind::thing || pixels[patches.find(i)] >= kSpeck) continue;
    cut.kind[i] = PixelKind::beyond;
    cut.depth[i] = 0.0F;
    cut.surface[i] = {};
  }
}

}  // namespace

std::vector<ObjectView> cut_out(const PreparedViews& prepared, int cluster, bool drop_outliers,
                                const RunContext& context) {
  std::vector<ObjectView> cuts;
  for (std::size_t k = 0; k < prepared.views.size(); ++k) {
    const DepthView& view = prepared.views[k];
    const CutFrame frame = cut_frame(view, prepared.cluster[k], cluster);
    if (frame.empty()) continue;
    ObjectView cut;
    cut.X_CP = (prepared.X_PW * view.camera.X_WC).inverse().cast<float>();
    cut.camera = view.camera;
    cut.left = frame.left;
    cut.top = frame.top;
    cut.width = frame.right - frame.left + 1;
    cut.height = frame.bottom - frame.top + 1;
    const std::size_t count = index(cut.width) * index(cut.height);
    cut.kind.assign(count, PixelKind::beyond);
    cut.depth.assign(count, 0.0F);
    cut.surface.assign(count, {});
    const Cutter cutter(prepared, k, cluster, drop_outliers);
    for_each_in_parallel(index(cut.height), context.threads, [&](std::size_t row) {
      context.cancellation.check();
      for (int u = frame.left; u <= frame.right; ++u) {
        cutter.decide(cut, frame, u, frame.top + static_cast<int>(row));
      }
    });
    if (drop_outliers) drop_specks(cut);
    find_edges(cut);
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

}  // namespace prehend
