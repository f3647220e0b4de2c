#include "sim/shape/cloud/image_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>

namespace prehend {
namespace {

constexpr float kAgreeingNormals = 0.7F;  // cosine of the angle between them
constexpr float kFar = 0.05F;

// 0 to 1, of how far a point is outside of what the thing may fill.
float contradiction_of(float distance, const SymmetryOptions& options) {
  return std::clamp((distance - options.tolerance) / (2.0F * options.tolerance), 0.0F, 1.0F);
}

}  // namespace

std::vector<SeenPoint> thinned_points(const std::vector<SeenPoint>& points, double apart,
                                      std::size_t most) {
  std::set<std::array<std::int64_t, 3>> taken;
  std::vector<SeenPoint> spread;
  for (const SeenPoint& point : points) {
    const Vector3 cell = (point.p_P / apart).array().floor();
    if (taken
            .insert({static_cast<std::int64_t>(cell.x()), static_cast<std::int64_t>(cell.y()),
                     static_cast<std::int64_t>(cell.z())})
            .second) {
      spread.push_back(point);
    }
  }
  if (spread.size() <= most) return spread;
  std::vector<SeenPoint> fewer;
  for (std::size_t i = 0; i < most; ++i) fewer.push_back(spread[i * spread.size() / most]);
  return fewer;
}

ImageScorer::ImageScorer(const std::vector<ObjectView>& views, const std::vector<SeenPoint>& points,
                         const SymmetryOptions& options)
    : views_(&views), points_(&points), options_(options) {}

float ImageScorer::contradiction(const Eigen::Vector3f& p_P) const {
  float distance = allowed_distance(*views_, p_P, kFar);
  if (options_.upright) distance = std::max(distance, -p_P.z());
  return contradiction_of(distance, options_);
}

ImageScore ImageScorer::of(const Congruence& image) const {
  double confirmed = 0.0;
  double contradicted = 0.0;
  for (const SeenPoint& point : *points_) {
    const Eigen::Vector3f p = image * point.p_P.cast<float>();
    float distance = options_.upright ? -p.z() : -kFar;
    float agreement = 0.0F;
    for (const ObjectView& view : *views_) {
      const PointSample here = sample(view, p, kFar);
      distance = std::max(distance, here.distance);
      if (here.surface == nullptr || std::abs(here.distance) > 2.0F * options_.tolerance) continue;
      const Eigen::Vector3f normal =
          view.X_CP.linear() * (image.linear() * point.normal_P.cast<float>());
      if (normal.dot(here.surface->normal()) < kAgreeingNormals) continue;
      const float off = here.distance / options_.tolerance;
      agreement = std::max(agreement, 1.0F - 0.25F * off * off);
    }
    const float contradiction = contradiction_of(distance, options_);
    contradicted += contradiction;
    if (contradiction == 0.0F) confirmed += agreement;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(points_->size(), 1));
  return {confirmed / count, contradicted / count};
}

ImageScore ImageScorer::of(const std::vector<Congruence>& images) const {
  ImageScore mean;
  for (const Congruence& image : images) {
    const ImageScore one = of(image);
    mean.confirmed += one.confirmed / static_cast<double>(images.size());
    mean.contradicted += one.contradicted / static_cast<double>(images.size());
  }
  return mean;
}

}  // namespace prehend
