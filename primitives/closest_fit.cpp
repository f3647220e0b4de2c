#include "primitives/closest_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>

#include "primitives/fit.h"
#include "primitives/quantile.h"

namespace prehend {
namespace {

// A turn and a shift in the primitive's frame, then its sizes.
constexpr int kRigid = 6;
constexpr int kMostSizes = 3;
constexpr int kUnknowns = kRigid + kMostSizes;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Normal = Eigen::Matrix<double, kUnknowns, kUnknowns>;

// The sizes of a shape, for reading and writing.
std::vector<double*> sizes_of(Shape& shape) {
  if (auto* box = std::get_if<Box>(&shape)) return {&box->size[0], &box->size[1], &box->size[2]};
  if (auto* sphere = std::get_if<Sphere>(&shape)) return {&sphere->radius};
  if (auto* tube = std::get_if<Cylinder>(&shape)) return {&tube->radius, &tube->height};
  if (auto* cone = std::get_if<Cone>(&shape)) {
    return {&cone->radius_low, &cone->radius_high, &cone->height};
  }
  return {};
}

Primitive changed(const Primitive& from, const Unknowns& by) {
  Primitive to = from;
  const Vector3 turn = by.head<3>();
  const double angle = turn.norm();
  Pose step = translation(by.segment<3>(3));
  if (angle > 0.0) step.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  to.X_OP = from.X_OP * step;
  const std::vector<double*> sizes = sizes_of(to.shape);
  for (std::size_t k = 0; k < sizes.size(); ++k) *sizes[k] += by[kRigid + static_cast<int>(k)];
  return to;
}

// Whether the sizes are possible, and the fit has not run away from where it started, as it may
// where points hardly determine it.
bool is_sound(Primitive primitive, Primitive start) {
  constexpr double kFarthest = 0.1;  // of a shift, a size
  constexpr double kMostTurned = 0.2;
  const std::vector<double*> sizes = sizes_of(primitive.shape);
  const std::vector<double*> before = sizes_of(start.shape);
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    if (!(*sizes[k] >= 0.0 && std::abs(*sizes[k] - *before[k]) <= kFarthest)) return false;
  }
  const Pose moved = start.X_OP.inverse() * primitive.X_OP;
  return moved.translation().norm() <= kFarthest &&
         Eigen::AngleAxisd(moved.linear()).angle() <= kMostTurned;
}

// The loss of a point at this distance whose weight is biweight(distance, cutoff).
double loss_of(double distance, double cutoff) {
  const double x = distance / cutoff;
  const double left = std::max(1.0 - x * x, 0.0);
  return cutoff * cutoff / 6.0 * (1.0 - left * left * left);
}

class ClosestFit {
 public:
  ClosestFit(const Primitive& start, std::span<const SurfacePoint> points)
      : points_(points), start_(start), best_(start) {}

  // One sequence of steps at a cutoff.
  void run(double cutoff) {
    constexpr int kSteps = 8;
    constexpr double kConverged = 1e-9;
    double damping = 1e-6;
    face();
    double loss = total_loss(best_, cutoff);
    for (int step = 0; step < kSteps; ++step) {
      const auto [normal, right] = equations(cutoff);
      bool better = false;
      double change = 0.0;
      while (!better && damping < 1e3) {
        Normal damped = normal;
        damped.diagonal() += Unknowns(damping * normal.diagonal()) +
                             Unknowns::Constant(1e-9 * normal.trace() + 1e-300);
        const Unknowns by = damped.ldlt().solve(right);
        const Primitive next = changed(best_, by);
        const double reached = is_sound(next, start_) ? total_loss(next, cutoff)
                                                      : std::numeric_limits<double>::infinity();
        better = reached < loss;
        damping *= better ? 0.1 : 10.0;
        if (!better) continue;
        change = by.norm();
        best_ = next;
        loss = reached;
      }
      if (!better || change < kConverged) return;
    }
  }

  // A cutoff that keeps what scatters as most of those within the last one do.
  double next_cutoff(double cutoff) const {
    std::vector<double> within;
    for (const SurfacePoint& s : points_) {
      const double distance = std::abs(signed_distance(best_, s.p_O));
      if (distance < cutoff) within.push_back(distance);
    }
    return within.empty() ? cutoff : std::min(cutoff, kCutoffMedians * quantile(within, 0.5));
  }

  const Primitive& best() const { return best_; }

 private:
  double total_loss(const Primitive& primitive, double cutoff) const {
    double loss = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      loss += facing_[i] * loss_of(signed_distance(primitive, points_[i].p_O), cutoff);
    }
    return loss;
  }

  // The direction in which the distance of a point in the primitive's frame grows. Distances are
  // differentiated by differences: kinds of primitives then need nothing but their distance.
  static Vector3 slope_at(const Primitive& at_home, const Vector3& q, double distance) {
    Vector3 slope;
    for (int k = 0; k < 3; ++k) {
      slope[k] =
          (signed_distance(at_home, q + kDifference * Vector3::Unit(k)) - distance) / kDifference;
    }
    return slope;
  }

  // The weights of the points by their normals (facing_weight).
  void face() {
    const Pose X_PO = best_.X_OP.inverse();
    const Primitive at_home{best_.shape, Pose::Identity()};
    facing_.clear();
    for (const SurfacePoint& s : points_) {
      const Vector3 q = X_PO * s.p_O;
      const Vector3 slope = slope_at(at_home, q, signed_distance(at_home, q));
      facing_.push_back(facing_weight(X_PO.linear() * s.n_O, slope));
    }
  }

  // Gauss-Newton's normal equations.
  std::pair<Normal, Unknowns> equations(double cutoff) const {
    Normal normal = Normal::Zero();
    Unknowns right = Unknowns::Zero();
    const Pose X_PO = best_.X_OP.inverse();
    const Primitive at_home{best_.shape, Pose::Identity()};
    std::array<Primitive, kMostSizes> larger;
    larger.fill(at_home);
    std::size_t sizes = 0;
    for (; sizes < sizes_of(larger[0].shape).size(); ++sizes) {
      *sizes_of(larger[sizes].shape)[sizes] += kDifference;
    }
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector3 q = X_PO * points_[i].p_O;
      const double distance = signed_distance(at_home, q);
      if (std::abs(distance) >= cutoff) continue;
      const Vector3 slope = slope_at(at_home, q, distance);
      const double weight = biweight(distance, cutoff) * facing_[i];
      Unknowns row = Unknowns::Zero();
      row.head<3>() = -q.cross(slope);
      row.segment<3>(3) = -slope;
      for (std::size_t k = 0; k < sizes; ++k) {
        row[kRigid + static_cast<int>(k)] =
            (signed_distance(larger[k], q) - distance) / kDifference;
      }
      normal += weight * row * row.transpose();
      right -= weight * distance * row;
    }
    return {normal, right};
  }

  static constexpr double kDifference = 1e-7;

  std::span<const SurfacePoint> points_;
  std::vector<double> facing_;  // of each point
  Primitive start_;
  Primitive best_;
};

}  // namespace

Primitive closest_fit(const Primitive& start, std::span<const SurfacePoint> points,
                      double tolerance) {
  constexpr int kRounds = 6;
  // Below this part of the tolerance, what is left is tessellation.
  constexpr double kFinest = 0.01;
  ClosestFit fit(start, points);
  double cutoff = tolerance;
  for (int round = 0; round < kRounds; ++round) {
    fit.run(cutoff);
    const double next = std::max(fit.next_cutoff(cutoff), kFinest * tolerance);
    if (next > 0.9 * cutoff) break;
    cutoff = next;
  }
  return fit.best();
}

}  // namespace prehend
