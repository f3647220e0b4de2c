#include "sim/motion/control/joint_curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace prehend {
namespace {

using Points = std::vector<std::vector<double>>;

// Waypoints closer than this fraction of the path's length say nothing about its direction but
// rounding, and knots that close would make the spline swing.
constexpr double kSamePoint = 1e-9;

// Indices of joints that do not keep the same value at all waypoints. The others need no limits,
// and would divide by zero if they have none.
std::vector<std::size_t> moving_joints(const Points& waypoints) {
  std::vector<std::size_t> moving;
  for (std::size_t j = 0; j < waypoints.front().size(); ++j) {
    const bool moves = std::any_of(waypoints.begin(), waypoints.end(),
                                   [&](const auto& q) { return q[j] != waypoints.front()[j]; });
    if (moves) moving.push_back(j);
  }
  return moving;
}

// The waypoints relative to the first, of the moving joints only. Short motions keep all their
// digits so.
Points offsets_of(const Points& waypoints, const std::vector<std::size_t>& moving) {
  Points offsets;
  offsets.reserve(waypoints.size());
  for (const std::vector<double>& q : waypoints) {
    std::vector<double> some;
    some.reserve(moving.size());
    for (const std::size_t j : moving) some.push_back(q[j] - waypoints.front()[j]);
    offsets.push_back(std::move(some));
  }
  return offsets;
}

std::vector<double> velocities_of(const JointLimits& limits,
                                  const std::vector<std::size_t>& moving) {
  std::vector<double> some;
  for (const std::size_t j : moving) some.push_back(limits.velocity[j]);
  return some;
}

// Euclidean distance with each joint in units of its velocity limit [s]. Never 0, so that knots
// increase. Computed with hypot, because the squares of very short distances underflow to 0.
double distance(const std::vector<double>& from, const std::vector<double>& to,
                const std::vector<double>& velocity) {
  double length = 1e-150;
  for (std::size_t j = 0; j < from.size(); ++j) {
    length = std::hypot(length, (to[j] - from[j]) / velocity[j]);
  }
  return length;
}

// The points without those that are at the same place as the one kept before them. The first and
// the last stay: where the last is too close to the one before, it takes its place.
Points distinct_points(const Points& points, const std::vector<double>& velocity) {
  double total = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    total += distance(points[i - 1], points[i], velocity);
  }
  // Distances are to the last kept point, not to the neighbour: a long chain of tiny steps must not
  // be dropped as a whole.
  Points kept{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (distance(kept.back(), points[i], velocity) > kSamePoint * total) kept.push_back(points[i]);
  }
  kept.back() = points.back();
  return kept;
}

// a + x * b
std::vector<double> sum(const std::vector<double>& a, double x, const std::vector<double>& b) {
  std::vector<double> result = a;
  for (std::size_t j = 0; j < a.size(); ++j) result[j] += x * b[j];
  return result;
}

// Collects the knots of a curve with rounded corners.
class Blending {
 public:
  explicit Blending(const std::vector<double>& start, const std::vector<double>& slope) {
    knots_.push_back(0.0);
    points_.push_back(start);
    slopes_.push_back(slope);
  }

  // A straight line or a cubic on to the knot. Where the line between two blends has no length but
  // rounding, the knot takes the place of the one before.
  void go_to(double knot, std::vector<double> point, std::vector<double> slope, double total) {
    if (knot - knots_.back() <= kSamePoint * total && knots_.size() > 1) {
      points_.back() = std::move(point);
      slopes_.back() = std::move(slope);
      return;
    }
    knots_.push_back(knot);
    points_.push_back(std::move(point));
    slopes_.push_back(std::move(slope));
  }

  PathSpline curve() { return {std::move(knots_), std::move(points_), std::move(slopes_)}; }

 private:
  std::vector<double> knots_;
  Points points_;
  Points slopes_;
};

}  // namespace

// Knots are chord lengths: a spline with evenly spaced knots would overshoot where the distances of
// the waypoints differ much.
JointCurve curve_through(const Points& waypoints, const JointLimits& limits) {
  const std::vector<std::size_t> moving = moving_joints(waypoints);
  const std::vector<double> velocity = velocities_of(limits, moving);
  Points points = distinct_points(offsets_of(waypoints, moving), velocity);
  std::vector<double> knots{0.0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    knots.push_back(knots.back() + distance(points[i - 1], points[i], velocity));
  }
  return {moving, waypoints.front(), waypoints.back(), {std::move(knots), std::move(points)}};
}

JointCurve blended_curve(const Points& waypoints, const std::vector<double>& blends,
                         const JointLimits& limits) {
  assert(waypoints.size() >= 2 && blends.size() + 2 == waypoints.size());
  const std::vector<std::size_t> moving = moving_joints(waypoints);
  const std::vector<double> velocity = velocities_of(limits, moving);
  const Points points = offsets_of(waypoints, moving);
  std::vector<double> lengths;
  Points slopes;  // of the lines
  double total = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    lengths.push_back(distance(points[i - 1], points[i], velocity));
    total += lengths.back();
    slopes.push_back(std::vector<double>(moving.size(), 0.0));
    for (std::size_t j = 0; j < moving.size(); ++j) {
      slopes.back()[j] = (points[i][j] - points[i - 1][j]) / lengths.back();
    }
  }
  Blending blending(points.front(), slopes.front());
  double corner = 0.0;  // its parameter
  for (std::size_t i = 0; i < blends.size(); ++i) {
    corner += lengths[i];
    const double half = 0.5 * blends[i] * std::min(lengths[i], lengths[i + 1]);
    const std::vector<double>& p = points[i + 1];
    const std::vector<double>& in = slopes[i];
    const std::vector<double>& out = slopes[i + 1];
    const std::vector<double> bend = sum(out, -1.0, in);
    blending.go_to(corner - half, sum(p, -half, in), in, total);
    blending.go_to(corner, sum(p, half / 6.0, bend), sum(in, 0.5, bend), total);
    blending.go_to(corner + half, sum(p, half, out), out, total);
  }
  blending.go_to(total, points.back(), slopes.back(), total);
  return {moving, waypoints.front(), waypoints.back(), blending.curve()};
}

}  // namespace prehend
