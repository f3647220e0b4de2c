#include "sim/shape/cloud/seen_surface.h"

#include <algorithm>
#include <array>

#include <Eigen/Cholesky>

namespace prehend {
namespace {

// Every so many pixels are enough to know the noise.
constexpr int kNoiseSamples = 40000;
// The median of the absolute value of a normal variable, in standard deviations; and the deviation
// of a - 2 b + c for three equal ones.
constexpr double kMedianOfNormal = 0.6745;
constexpr double kSecondDifference = 2.449489742783178;
constexpr double kLeastNoise = 1e-4;
// Surfaces that are steeper than this against the pixel are not followed: a depth that changes more
// than so many times the way across is an edge.
constexpr double kSteepest = 3.0;
// Of the window, for a plane to be one.
constexpr int kLeastReadings = 9;

// Sums of a least-squares plane w = a + b du + c dv.
struct PlaneSums {
  double n = 0.0;
  double u = 0.0;
  double v = 0.0;
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
  double w = 0.0;
  double uw = 0.0;
  double vw = 0.0;

  void add(double du, double dv, double inverse) {
    n += 1.0;
    u += du;
    v += dv;
    uu += du * du;
    uv += du * dv;
    vv += dv * dv;
    w += inverse;
    uw += du * inverse;
    vw += dv * inverse;
  }

  // a, b, c; b and c are 0 where the readings lie on a line.
  Vector3 solve() const {
    const double su = u / n;
    const double sv = v / n;
    const double cuu = uu - u * su;
    const double cuv = uv - u * sv;
    const double cvv = vv - v * sv;
    const double cuw = uw - w * su;
    const double cvw = vw - w * sv;
    const double det = cuu * cvv - cuv * cuv;
    if (det < 1e-3 * cuu * cvv + 1e-12) return {w / n, 0.0, 0.0};
    const double b = (cvv * cuw - cuv * cvw) / det;
    const double c = (cuu * cvw - cuv * cuw) / det;
    return {w / n - b * su - c * sv, b, c};
  }
};

}  // namespace

double noise_of(const DepthView& view) {
  const int width = view.camera.width;
  const std::size_t count = view.depth.size();
  const std::size_t stride = std::max<std::size_t>(1, count / kNoiseSamples);
  std::vector<double> differences;
  for (std::size_t i = 0; i < count; i += stride) {
    const auto u = static_cast<int>(i % index(width));
    if (u < 1 || u + 1 >= width) continue;
    const double before = view.depth[i - 1];
    const double here = view.depth[i];
    const double after = view.depth[i + 1];
    if (before <= 0.0 || here <= 0.0 || after <= 0.0) continue;
    const double difference = std::abs(before - 2.0 * here + after);
    if (difference < 0.05 * here) differences.push_back(difference);
  }
  if (differences.empty()) return kLeastNoise;
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return std::max(kLeastNoise, *middle / (kMedianOfNormal * kSecondDifference));
}

PlaneFitter::PlaneFitter(const DepthView& view, double noise)
    : view_(&view), noise_(noise), radius_(noise < 4e-4 ? 2 : (noise < 2.2e-3 ? 3 : 4)) {}

LocalPlane PlaneFitter::at(int u, int v) const {
  const DepthCamera& camera = view_->camera;
  const auto depth_of = [&](int x, int y) {
    return static_cast<double>(view_->depth[index(y) * index(camera.width) + index(x)]);
  };
  const double here = depth_of(u, v);
  if (here <= 0.0) return {};
  const int left = std::max(-radius_, -u);
  const int right = std::min(radius_, camera.width - 1 - u);
  const int top = std::max(-radius_, -v);
  const int bottom = std::min(radius_, camera.height - 1 - v);
  const double across = here / std::min(camera.fx, camera.fy);
  // Weights are 0 or 1, so that two readings are as far apart as their noise and the slope say.
  PlaneSums first;
  for (int dv = top; dv <= bottom; ++dv) {
    for (int du = left; du <= right; ++du) {
      const double depth = depth_of(u + du, v + dv);
      if (depth <= 0.0) continue;
      const double way = across * std::max(std::abs(du), std::abs(dv));
      if (std::abs(depth - here) <= 4.0 * noise_ + kSteepest * way) first.add(du, dv, 1.0 / depth);
    }
  }
  if (first.n < kLeastReadings) return {};
  const Vector3 guess = first.solve();
  const double inverse_noise = 3.0 * noise_ / (here * here);
  PlaneSums second;
  for (int dv = top; dv <= bottom; ++dv) {
    for (int du = left; du <= right; ++du) {
      const double depth = depth_of(u + du, v + dv);
      if (depth <= 0.0) continue;
      const double expected = guess[0] + guess[1] * du + guess[2] * dv;
      if (std::abs(1.0 / depth - expected) <= inverse_noise) second.add(du, dv, 1.0 / depth);
    }
  }
  const Vector3 fit = second.n < kLeastReadings ? guess : second.solve();
  // 1/z = a + b (x' - u) + c (y' - v) with x' = fx x/z + cx, multiplied by z.
  const double b = fit[1];
  const double c = fit[2];
  const Vector3 inverse(camera.fx * b, camera.fy * c,
                        fit[0] + b * (camera.cx - u) + c * (camera.cy - v));
  // The plane must be met by the ray near the reading.
  const double met = 1.0 / std::max(fit[0], 1e-9);
  if (std::abs(met - here) > 4.0 * noise_ + 2.0 * across) return {};
  LocalPlane plane{inverse.cast<float>()};
  // A plane seen from beyond grazing by noise: the reading's own distance is what remains.
  if (!plane.exists()) plane.inverse = {0.0F, 0.0F, static_cast<float>(fit[0])};
  return plane;
}

}  // namespace prehend
