#include "sim/shape/cloud/complete_shape.h"

#include <algorithm>
#include <cmath>

#include "sim/base/parallel/parallel.h"
#include "sim/shape/cloud/plan_cover.h"

namespace prehend {
namespace {

constexpr int kMargin = 4;                   // cells of the grid around the body
constexpr double kMostCells = 3e6;           // of a grid; larger things get larger cells
constexpr std::size_t kExtentPoints = 4000;  // that settle the size of the grid
constexpr float kRealWeight = 4.0F;          // of a view, beside that of its image
constexpr float kEdgeWeight = 0.3F;          // of the edge of a thing in a view, beside its surface

// How deep the body is assumed to be behind a surface of which it is `width` to the edge: that of a
// round bar for narrow parts, less for wide ones [m].
float assumed_depth(float width, float factor) {
  return factor * std::min(2.0F * width, 0.02F + 0.5F * width);
}

// A view, or its image: points are taken into the view by `into`.
struct Witness {
  Congruence into;
  const ObjectView* view;
  bool real;
};

// What witnesses say of a point.
struct Evidence {
  float most = 0.0F;  // of their distances
  float sum = 0.0F;   // of the distances of those that see a surface near the point
  float weights = 0.0F;
  float behind = 0.0F;  // how far it is behind what is assumed to be filled
  bool shell = false;   // right behind a seen surface
  bool seen = false;    // near one
};

class Completion {
 public:
  Completion(const std::vector<ObjectView>& views, const std::vector<SeenPoint>& points,
             const FoundSymmetry& symmetry, const SymmetryOptions& judged,
             const CompletionOptions& options)
      : views_(views), points_(points), symmetry_(symmetry), options_(options) {
    mark_apart(judged);
    size_grid();
    for (const ObjectView& view : views) {
      real_.push_back({Congruence::Identity(), &view, true});
      for (const Congruence& image : symmetry.images) {
        images_.push_back({image.inverse(), &view, false});
      }
    }
    cover();
  }

  DistanceGrid run(const RunContext& context) {
    grid_.value.resize(index(grid_.size[0]) * index(grid_.size[1]) * index(grid_.size[2]));
    seen_.resize(grid_.value.size());
    for_each_in_parallel(index(grid_.size[2]), context.threads, [&](std::size_t z) {
      context.cancellation.check();
      fill_layer(static_cast<int>(z));
    });
    for (int round = 0; round < 2; ++round) {
      for (std::size_t axis = 0; axis < 3; ++axis) smooth_unseen(axis);
    }
    return std::move(grid_);
  }

 private:
  float cell() const { return static_cast<float>(grid_.edge); }
  float far() const { return 4.0F * cell(); }

  // Of each pixel that shows the thing, whether the symmetry leaves it out.
  void mark_apart(const SymmetryOptions& judged) {
    for (const ObjectView& view : views_) apart_.emplace_back(view.kind.size(), 0);
    if (symmetry_.images.empty() || symmetry_.apart == 0.0) return;
    const std::vector<float> against = contradictions(views_, points_, symmetry_.images, judged);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      apart_[index(points_[i].view)][points_[i].pixel] = against[i] > 0.2F ? 1 : 0;
    }
  }

  void size_grid() {
    Bounds box;
    const auto include = [&](const Vector3& p) {
      box.lower = box.lower.cwiseMin(p);
      box.upper = box.upper.cwiseMax(p);
    };
    const std::size_t stride = std::max<std::size_t>(1, points_.size() / kExtentPoints);
    for (std::size_t i = 0; i < points_.size(); i += stride) {
      const SeenPoint& point = points_[i];
      include(point.p_P);
      const ObjectView& view = views_[index(point.view)];
      const Vector3 camera = view.X_CP.inverse().translation().cast<double>();
      const double depth = static_cast<double>(assumed_depth(
          static_cast<float>(point.width), static_cast<float>(options_.depth_factor)));
      const Vector3 back = point.p_P + depth * (point.p_P - camera).normalized();
      if (symmetry_.images.empty()) include(back);
      for (const Congruence& image : symmetry_.images) {
        include((image * point.p_P.cast<float>()).cast<double>());
      }
    }
    if (options_.on_support) {
      box.lower.z() = 0.0;
      box.upper.z() = std::max(box.upper.z(), options_.voxel);
    }
    grid_.edge = std::min(options_.voxel, std::max(0.5 * options_.voxel, box.diagonal() / 60.0));
    const double margin = 2.0 * kMargin;
    const auto cells = [&](double edge) {
      return (box.size().array() / edge + margin + 1.0).prod();
    };
    while (cells(grid_.edge) > kMostCells) grid_.edge *= 1.1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double extent = box.size()[static_cast<Eigen::Index>(k)];
      grid_.size[k] = static_cast<int>(std::ceil(extent / grid_.edge + margin)) + 1;
    }
    grid_.lower = box.lower - Vector3::Constant(kMargin * grid_.edge);
    // The support lies between two layers, so that it is met exactly.
    if (options_.on_support) grid_.lower.z() = -(kMargin - 0.5) * grid_.edge;
  }

  void cover() {
    cover_.emplace(grid_.lower, grid_.edge, grid_.size[0], grid_.size[1]);
    const std::size_t stride =
        std::max<std::size_t>(1, points_.size() * symmetry_.images.size() / 200000);
    for (const SeenPoint& point : points_) cover_->add(point.p_P.cast<float>());
    for (std::size_t i = 0; i < points_.size(); i += stride) {
      for (const Congruence& image : symmetry_.images) {
        cover_->add(image * points_[i].p_P.cast<float>());
      }
    }
    cover_->finish();
  }

  void ask(const Witness& witness, const Eigen::Vector3f& p_P, Evidence& evidence) const {
    const PointSample here = sample(*witness.view, witness.into * p_P, far());
    evidence.most = std::max(evidence.most, here.distance);
    const float reach = 2.0F * cell();
    if (here.distance > -reach) {
      const float fade = std::clamp((here.distance + reach) / cell(), 0.0F, 1.0F);
      const float weight = fade * (witness.real ? kRealWeight : 1.0F) *
                           (here.surface != nullptr ? 1.0F : kEdgeWeight);
      evidence.sum += weight * here.distance;
      evidence.weights += weight;
    }
    if (here.surface == nullptr) return;
    const Eigen::Vector3f p_C = witness.view->X_CP * (witness.into * p_P);
    const float behind = -here.surface->distance(p_C);
    const float depth = assumed_depth(here.width, static_cast<float>(options_.depth_factor));
    evidence.behind = std::min(evidence.behind, behind - depth);
    evidence.seen = evidence.seen || std::abs(behind) < 1.5F * cell();
    if (!witness.real) return;
    if (behind < -0.5F * cell()) return;
    const std::size_t i = static_cast<std::size_t>(here.surface - witness.view->surface.data());
    const bool apart = apart_[index(static_cast<int>(witness.view - views_.data()))][i] != 0;
    evidence.shell =
        evidence.shell || behind < (apart ? std::max(depth, 0.9F * cell()) : 0.9F * cell());
  }

  float value_at(const Eigen::Vector3f& p_P, char& near_seen) const {
    const float support = options_.on_support ? -p_P.z() : -far();
    if (support >= cell()) return far();
    Evidence evidence{.most = -far(), .behind = far()};
    for (const Witness& witness : real_) ask(witness, p_P, evidence);
    const float real_most = evidence.most;
    if (real_most >= 2.0F * cell()) return far();
    const float seen = std::max(mean_of(evidence), real_most - 0.3F * cell());
    for (const Witness& witness : images_) ask(witness, p_P, evidence);
    near_seen = evidence.seen ? 1 : 0;
    float value = std::max({mean_of(evidence), evidence.most - cell(), real_most - 0.3F * cell()});
    float assumed = evidence.behind;
    if (options_.on_support) assumed = std::min(assumed, cover_->distance(p_P));
    value = std::max(value, assumed);
    if (evidence.shell) value = std::min(value, seen);
    return std::clamp(std::max(value, support), -far(), far());
  }

  float mean_of(const Evidence& evidence) const {
    return evidence.weights > 0.0F ? evidence.sum / evidence.weights : -far();
  }

  void fill_layer(int z) {
    for (int y = 0; y < grid_.size[1]; ++y) {
      for (int x = 0; x < grid_.size[0]; ++x) {
        const std::size_t i = grid_.at(x, y, z);
        grid_.value[i] = value_at(grid_.corner(x, y, z).cast<float>(), seen_[i]);
      }
    }
  }

  // Weights of 1/4, 1/2, 1/4 along an axis: what was not seen is known too roughly for details. The
  // support stays where it is.
  void smooth_unseen(std::size_t axis) {
    const std::array<std::size_t, 3> steps = {1, grid_.at(0, 1, 0), grid_.at(0, 0, 1)};
    const std::size_t step = steps[axis];
    const std::vector<float> before = grid_.value;
    const int lowest = options_.on_support ? kMargin + 1 : 1;
    for (int z = lowest; z + 1 < grid_.size[2]; ++z) {
      for (int y = 1; y + 1 < grid_.size[1]; ++y) {
        for (int x = 1; x + 1 < grid_.size[0]; ++x) {
          const std::size_t i = grid_.at(x, y, z);
          if (seen_[i] != 0) continue;
          grid_.value[i] = 0.5F * before[i] + 0.25F * (before[i - step] + before[i + step]);
        }
      }
    }
  }

  const std::vector<ObjectView>& views_;
  const std::vector<SeenPoint>& points_;
  const FoundSymmetry& symmetry_;
  CompletionOptions options_;
  DistanceGrid grid_;
  std::vector<char> seen_;  // of each corner: whether it is near a seen surface
  std::vector<std::vector<char>> apart_;
  std::vector<Witness> real_;
  std::vector<Witness> images_;
  std::optional<PlanCover> cover_;
};

}  // namespace

DistanceGrid complete_shape(const std::vector<ObjectView>& views,
                            const std::vector<SeenPoint>& points, const FoundSymmetry& symmetry,
                            const SymmetryOptions& judged, const CompletionOptions& options,
                            const RunContext& context) {
  return Completion(views, points, symmetry, judged, options).run(context);
}

}  // namespace prehend
