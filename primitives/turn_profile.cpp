#include "primitives/turn_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Cholesky>

#include "primitives/fit.h"
#include "primitives/quantile.h"

namespace prehend {
namespace {

// Lengths are in the unit of the scaled mesh, whose bounding box has a diagonal of 1.

// A point of the side, seen from outside. What faces along the axis is an end, what faces inward
// the inside of a wall: neither says how large the radius is.
bool is_side(const SeenFromAxis& s) { return s.outward > 0.2 && std::abs(s.tangential) < 0.6; }

// A point that shows that the section is no circle about the axis, as the side of a box.
bool is_astray(const SeenFromAxis& s) { return std::abs(s.tangential) >= 0.7; }

std::size_t step_of(double z, const TurnProfile& profile) {
  const double steps = std::max((z - profile.low) / profile.step, 0.0);
  return std::min(static_cast<std::size_t>(steps), TurnProfile::kSteps - 1);
}

constexpr double kOfLength = 0.1;

// Enters a step that has next to no side, such as the foot of a glass: a disc reaches as far as
// nearly all of its points.
void enter_disc(std::size_t k, const std::vector<SeenFromAxis>& points, std::size_t whole,
                TurnProfile& profile) {
  constexpr std::size_t kFewest = 20;
  constexpr double kNearlyAll = 0.97;
  constexpr std::size_t kSectors = 12;
  std::vector<double> radii;
  std::array<double, kSectors> reach = {};
  for (const SeenFromAxis& s : points) {
    radii.push_back(s.radius);
    const double turns = s.angle / (2.0 * std::numbers::pi) + 0.5;
    double& farthest = reach[std::min(static_cast<std::size_t>(turns * kSectors), kSectors - 1)];
    farthest = std::max(farthest, s.radius);
  }
  if (radii.size() < kFewest) return;
  const double radius = quantile(radii, kNearlyAll);
  const bool round = std::all_of(reach.begin(), reach.end(), [&](double farthest) {
    return std::abs(farthest - radius) < 0.1 * radius;
  });
  if (!round) return;
  profile.radius[k] = radius;
  profile.share[k] =
      static_cast<double>(radii.size()) / static_cast<double>(whole) + kOfLength * profile.step;
}

// Enters a step from the points there, unless they are no circle.
void enter_step(std::size_t k, const std::vector<SeenFromAxis>& points, std::size_t whole,
                TurnProfile& profile) {
  constexpr double kApart = 0.015;  // farther from the middle radius a point is of something else
  constexpr double kLeastShare = 0.5;
  constexpr std::size_t kFewest = 3;
  constexpr std::size_t kSectors = 12;
  constexpr auto kFewestSectors = 3;
  std::vector<double> radii;
  for (const SeenFromAxis& s : points) {
    if (is_side(s)) radii.push_back(s.radius);
  }
  if (radii.size() < kFewest) {
    enter_disc(k, points, whole, profile);
    return;
  }
  const double middle = quantile(radii, 0.5);
  std::array<bool, kSectors> seen = {};
  double sum = 0.0;
  std::size_t on = 0;
  std::size_t off = 0;
  for (const SeenFromAxis& s : points) {
    if (s.outward > 0.2 && !is_astray(s) && std::abs(s.radius - middle) < kApart) {
      const double turns = s.angle / (2.0 * std::numbers::pi) + 0.5;
      seen[std::min(static_cast<std::size_t>(turns * kSectors), kSectors - 1)] = true;
      sum += s.radius;
      ++on;
    } else if (s.outward > 0.2 || is_astray(s)) {
      ++off;
    }
  }
  const double share = static_cast<double>(on) / static_cast<double>(on + off);
  if (on == 0 || share < kLeastShare) return;
  if (std::count(seen.begin(), seen.end(), true) < kFewestSectors) return;
  profile.radius[k] = sum / static_cast<double>(on);
  profile.share[k] =
      static_cast<double>(on) / static_cast<double>(whole) + kOfLength * profile.step;
}

}  // namespace

TurnProfile turn_profile(const TurnAxis& axis, std::span<const SurfacePoint> points,
                         std::size_t whole) {
  constexpr double kShortestStep = 1e-6;
  TurnProfile profile;
  const std::vector<SeenFromAxis> seen = seen_from(axis, points);
  const auto [low, high] =
      std::minmax_element(seen.begin(), seen.end(),
                          [](const SeenFromAxis& a, const SeenFromAxis& b) { return a.z < b.z; });
  profile.low = low->z;
  profile.step =
      std::max((high->z - low->z) / static_cast<double>(TurnProfile::kSteps), kShortestStep);
  std::array<std::vector<SeenFromAxis>, TurnProfile::kSteps> of_step;
  for (const SeenFromAxis& s : seen) of_step[step_of(s.z, profile)].push_back(s);
  for (std::size_t k = 0; k < TurnProfile::kSteps; ++k) {
    enter_step(k, of_step[k], whole, profile);
  }
  return profile;
}

TurnAxis centered(const TurnAxis& axis, const TurnProfile& profile,
                  std::span<const SurfacePoint> points) {
  constexpr double kCutoff = 0.03;
  constexpr double kOpen = 1e-6;
  // Two shifts and two tilts, about the middle of the profile.
  Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  const double middle = profile.at(TurnProfile::kSteps / 2);
  const std::vector<SeenFromAxis> seen = seen_from(axis, points);
  for (const SeenFromAxis& s : seen) {
    const std::size_t k = step_of(s.z, profile);
    if (!(profile.share[k] > 0.0) || s.outward <= 0.2 || is_astray(s)) continue;
    const double residual = s.radius - profile.radius[k];
    const double weight = biweight(residual, kCutoff) * s.outward;
    const double x = std::cos(s.angle);
    const double y = std::sin(s.angle);
    const Eigen::Vector4d row(x, y, x * (s.z - middle), y * (s.z - middle));
    normal += weight * row * row.transpose();
    right += weight * residual * row;
  }
  normal.diagonal().array() += kOpen * normal.trace() + 1e-12;
  const Eigen::Vector4d by = normal.ldlt().solve(right);
  const Vector3 x = axis.direction_O.unitOrthogonal();
  const Vector3 y = axis.direction_O.cross(x);
  TurnAxis to;
  to.direction_O = (axis.direction_O + by[2] * x + by[3] * y).normalized();
  to.p_O = axis.p_O + middle * axis.direction_O + by[0] * x + by[1] * y - middle * to.direction_O;
  return to;
}

}  // namespace prehend
